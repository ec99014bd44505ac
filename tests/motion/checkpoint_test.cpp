// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/checkpoint.h"

#include <bit>
#include <catch2/catch.hpp>
#include <limits>
#include <sstream>

#include "core/errors.h"
#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::motion;

namespace {

const std::vector<double> awkward{0.0, -0.0, 0.1, 5e-324, -1.7e308, std::numeric_limits<double>::infinity(), NAN};
const std::vector<std::int32_t> labels{0, -1, 7, std::numeric_limits<std::int32_t>::min()};
const std::vector<std::uint64_t> large{0, std::numeric_limits<std::uint64_t>::max()};
const std::vector<std::uint8_t> small{0, 1, 255};

std::string state() {
    CheckpointWriter out("flow", 3);
    out.add("time", 0.1);
    out.add_array<double>("positions", awkward);
    out.add_array<std::int32_t>("labels", labels);
    out.add_array<std::uint64_t>("large", large);
    out.add_array<std::uint8_t>("small", small);
    out.add_array<std::uint32_t>("nothing", {});
    out.add("count", std::int64_t{-5});
    out.add_text("motion", "rotate\nby 1");
    std::ostringstream stream;
    out.write(stream);
    return stream.str();
}

CheckpointReader reader(const std::string& bytes, std::string_view kind = "flow", std::uint32_t version = 3) {
    std::istringstream stream(bytes);
    return CheckpointReader(stream, "run/checkpoint", kind, version);
}

}  // namespace

TEST_CASE("what is written is read back bit for bit") {
    CheckpointReader in = reader(state());
    CHECK(in.number("time") == 0.1);
    const std::vector<double> positions = in.array<double>("positions", awkward.size());
    for (std::size_t i = 0; i < awkward.size(); ++i) {
        CHECK(std::bit_cast<std::uint64_t>(positions[i]) == std::bit_cast<std::uint64_t>(awkward[i]));
    }
    CHECK(in.array<std::int32_t>("labels") == labels);
    CHECK(in.array<std::uint64_t>("large") == large);
    CHECK(in.array<std::uint8_t>("small") == small);
    CHECK(in.array<std::uint32_t>("nothing").empty());
    CHECK(in.value<std::int64_t>("count") == -5);
    CHECK(in.text("motion") == "rotate\nby 1");
    CHECK_NOTHROW(in.require_end());
    CHECK(state() == state());
}

TEST_CASE("the bytes are little endian, on any machine") {
    CheckpointWriter out("k", 1);
    out.add("v", std::uint32_t{0x01020304});
    std::ostringstream stream;
    out.write(stream);
    const std::string bytes = stream.str();
    CHECK(bytes.substr(bytes.size() - 12, 4) == std::string("\x04\x03\x02\x01"));
}

TEST_CASE("a checkpoint that was cut anywhere is refused") {
    const std::string whole = state();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        REQUIRE_THROWS_AS(reader(whole.substr(0, size)), core::InputError);
    }
    CHECK_THROWS_WITH(
        reader(whole.substr(0, whole.size() - 1)),
        "run/checkpoint: is damaged or cut off: its checksum is wrong; start anew, or resume from another "
        "checkpoint");
    CHECK_THROWS_AS(reader(whole + "x"), core::InputError);
}

TEST_CASE("a checkpoint in which any byte was changed is refused") {
    core::Random random(tests::seed(1));
    const std::string whole = state();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ static_cast<char>(1 + random.below(255)));
        REQUIRE_THROWS_AS(reader(damaged), core::InputError);
    }
}

TEST_CASE("what is not what was asked for is named") {
    CHECK_THROWS_WITH(reader("no checkpoint at all"), Catch::Contains("is no checkpoint"));
    CHECK_THROWS_WITH(reader(state(), "fluid"), Catch::Contains("is a checkpoint of 'flow'"));
    CHECK_THROWS_WITH(reader(state(), "flow", 4), Catch::Contains("has version 3 where 4 is read"));

    CheckpointReader in = reader(state());
    CHECK_THROWS_WITH(in.number("speed"), Catch::Contains("entry 'speed': there is 'time' in its place"));
    in = reader(state());
    CHECK_THROWS_WITH(in.value<std::int32_t>("time"), Catch::Contains("entry 'time': has another type"));
    in = reader(state());
    in.number("time");
    CHECK_THROWS_WITH(in.array<double>("positions", 3), Catch::Contains("has 7 values where 3 are expected"));
    CHECK_THROWS_WITH(in.require_end(), Catch::Contains("has more entries"));

    std::ostringstream stream;
    CheckpointWriter("flow", 3).write(stream);
    in = reader(stream.str());
    CHECK_THROWS_WITH(in.number("time"), Catch::Contains("has fewer entries"));
}

TEST_CASE("a stream that fails is reported") {
    std::ostringstream stream;
    stream.setstate(std::ios::badbit);
    CHECK_THROWS_AS(CheckpointWriter("flow", 1).write(stream), core::RunError);
}
