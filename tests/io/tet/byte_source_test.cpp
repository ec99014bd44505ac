// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/byte_source.h"

#include <zlib.h>

#include <catch2/catch.hpp>
#include <string>

#include "core/random.h"
#include "io/vtk_array.h"
#include "tests/support/seed.h"

using namespace dsc::io::tet;
using dsc::core::Random;
using dsc::io::base64;

namespace {

std::string random_bytes(Random& random, std::size_t size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(random.below(256));
    return bytes;
}

// All of it, in pieces of random sizes; empty when the source fails on the way or has more.
std::string all_of(ByteSource& source, std::size_t size, Random& random) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size;) {
        const std::size_t count = std::min(size - i, 1 + random.below(20));
        if (!source.read(std::span(bytes).subspan(i, count))) return "";
        i += count;
    }
    char more = 0;
    return source.read(std::span(&more, 1)) ? "" : bytes;
}

std::string packed(const std::string& bytes) {
    std::string result(::compressBound(bytes.size()), '\0');
    uLongf size = result.size();
    ::compress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
               bytes.size());
    return result.substr(0, size);
}

}  // namespace

TEST_CASE("bytes come out as they went in") {
    Random random(dsc::tests::seed(31));
    for (std::size_t size = 1; size < 60; ++size) {
        const std::string bytes = random_bytes(random, size);
        CHECK(all_of(*raw_bytes(bytes), size, random) == bytes);
        const std::string text = base64(bytes);
        CHECK(all_of(*base64_bytes(text), size, random) == bytes);
        // As VTK and others break lines, and encode a header apart from its data.
        const std::string spaced = "\n  " + text.substr(0, 2) + " \n" + text.substr(2) + "\n" + text;
        CHECK(all_of(*base64_bytes(spaced), 2 * size, random) == bytes + bytes);
        const std::string other = random_bytes(random, 7);
        const std::string blocks = packed(bytes) + packed(other);
        CHECK(all_of(*inflated_bytes(raw_bytes(blocks), {{size, packed(bytes).size()}, {7, packed(other).size()}}),
                     size + 7, random) == bytes + other);
    }
}

TEST_CASE("damaged bytes are refused") {
    std::string bytes(6, '\0');
    CHECK_FALSE(raw_bytes("abcde")->read(bytes));
    for (const char* text : {"", "Zm9v", "Zm9vYmF", "Zm9v*mFy", "Zm9=YmFy", "====YmFy", "Z===YmFyYmFy"}) {
        INFO(text);
        CHECK_FALSE(base64_bytes(text)->read(bytes));
    }
    const std::string good = packed("abcdef");
    CHECK(inflated_bytes(raw_bytes(good), {{6, good.size()}})->read(bytes));
    CHECK_FALSE(inflated_bytes(raw_bytes(good), {{5, good.size()}})->read(bytes));
    CHECK_FALSE(inflated_bytes(raw_bytes(good), {{7, good.size()}})->read(bytes));
    CHECK_FALSE(inflated_bytes(raw_bytes(good), {{6, good.size() - 1}})->read(bytes));
    CHECK_FALSE(inflated_bytes(raw_bytes(good), {{6, good.size() + 1}})->read(bytes));
    CHECK_FALSE(inflated_bytes(raw_bytes(good), {{0, 0}})->read(bytes));
}

TEST_CASE("a block that zlib could not have packed is not believed") {
    const std::string zeros = packed(std::string(1 << 20, '\0'));
    CHECK(is_possible({1 << 20, zeros.size()}));
    CHECK_FALSE(is_possible({std::uint64_t{1} << 40, 1000}));
}
