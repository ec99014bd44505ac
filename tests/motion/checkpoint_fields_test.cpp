// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/checkpoint_fields.h"

#include <bit>
#include <catch2/catch.hpp>
#include <limits>
#include <sstream>

#include "core/errors.h"
#include "core/fields.h"

using namespace dsc;
using namespace dsc::motion;

namespace {

struct Place {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2i cell = Eigen::Vector2i::Zero();
    bool is_locked = false;
    bool operator==(const Place&) const = default;
};

template <class Visitor, core::ConstOrNot<Place> Value>
void fields(Visitor& visitor, Value& place) {
    auto& [position, cell, is_locked] = place;
    visitor(position, cell, is_locked);
}

struct Record {
    std::uint64_t count = 0;
    std::string name;
    std::vector<Place> places;
    std::vector<std::pair<std::string, double>> times;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    Eigen::AlignedBox2d box;
    std::vector<std::vector<double>> nested;
};

template <class Visitor, core::ConstOrNot<Record> Value>
void fields(Visitor& visitor, Value& record) {
    auto& [count, name, places, times, triangles, box, nested] = record;
    visitor(count, name, places, times, triangles, box, nested);
}

Record record() {
    Record record;
    record.count = std::numeric_limits<std::uint64_t>::max();
    record.name = "with a\nline";
    record.places = {{{0.1, -0.0}, {-1, 2}, true}, {{5e-324, 1e300}, {0, 0}, false}};
    record.times = {{"targets", 0.5}, {"", -1}};
    record.triangles = {{1, 2, std::numeric_limits<std::uint32_t>::max()}};
    record.box = {Eigen::Vector2d(0, 1), Eigen::Vector2d(2, 3)};
    record.nested = {{}, {1, 2, 3}, {NAN}};
    return record;
}

CheckpointReader checkpoint(const auto&... values) {
    FieldWriter writer;
    writer(values...);
    CheckpointWriter out("test", 1);
    writer.write(out, "run");
    std::stringstream stream;
    out.write(stream);
    return {stream, "file", "test", 1};
}

}  // namespace

TEST_CASE("structs of structs are read back bit for bit") {
    const Record written = record();
    CheckpointReader in = checkpoint(written);
    FieldReader reader(in, "run");
    Record read;
    reader(read);
    reader.require_end();
    in.require_end();
    CHECK(read.count == written.count);
    CHECK(read.name == written.name);
    CHECK(read.places == written.places);
    CHECK(std::signbit(read.places[0].position.y()));
    CHECK(read.times == written.times);
    CHECK(read.triangles == written.triangles);
    CHECK(read.box.min() == written.box.min());
    CHECK(read.box.max() == written.box.max());
    REQUIRE(read.nested.size() == 3);
    CHECK(read.nested[1] == written.nested[1]);
    CHECK(std::isnan(read.nested[2][0]));
}

TEST_CASE("fields that were not written are refused before anything is made of them") {
    const auto refuses = [](CheckpointReader in, auto value) {
        FieldReader reader(in, "run");
        CHECK_THROWS_AS(reader(value), core::InputError);
    };
    refuses(checkpoint(1.5), int());
    refuses(checkpoint(1), double());
    refuses(checkpoint(std::int64_t{1} << 60), std::vector<Place>());
    refuses(checkpoint(-1), std::vector<int>());
    refuses(checkpoint(3), std::string());
    CheckpointReader in = checkpoint(1, 2);
    FieldReader reader(in, "run");
    int value = 0;
    reader(value);
    CHECK_THROWS_WITH(reader.require_end(), Catch::Contains("more values than expected"));
}
