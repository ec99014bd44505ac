// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/number_stream.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

#include "core/errors.h"

using namespace dsc::io::tet;
using dsc::core::InputError;

namespace {

template <class T>
std::string image(const std::vector<T>& values, std::endian order) {
    std::string bytes;
    for (const T value : values) {
        std::string one(reinterpret_cast<const char*>(&value), sizeof value);
        if (order != std::endian::native) std::reverse(one.begin(), one.end());
        bytes += one;
    }
    return bytes;
}

template <class T>
void check_type(NumberType type) {
    CHECK(size_of(type) == sizeof(T));
    // More than one chunk, with the extremes.
    std::vector<T> values = {std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max(), T{0}};
    for (int i = 0; i < 10'000; ++i) values.push_back(static_cast<T>(i % 100));
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const std::string bytes = image(values, order);
        const auto stream = binary_numbers({"f", "x", type, order, values.size()}, raw_bytes(bytes));
        CHECK(stream->most() == values.size());
        bool is_same = true;
        for (const T value : values) is_same = is_same && stream->next() == static_cast<double>(value);
        CHECK(is_same);
        CHECK_NOTHROW(stream->require_end());
        CHECK_THROWS_WITH(stream->next(), Catch::Contains("f: number 10003 of x: there are fewer numbers"));
    }
}

std::unique_ptr<NumberStream> doubles(const std::vector<double>& values, const std::string& bytes) {
    return binary_numbers({"f", "x", NumberType::float64, std::endian::little, values.size()}, raw_bytes(bytes));
}

}  // namespace

TEST_CASE("numbers of every type and order of bytes come out") {
    check_type<std::int8_t>(NumberType::int8);
    check_type<std::uint8_t>(NumberType::uint8);
    check_type<std::int16_t>(NumberType::int16);
    check_type<std::uint16_t>(NumberType::uint16);
    check_type<std::int32_t>(NumberType::int32);
    check_type<std::uint32_t>(NumberType::uint32);
    check_type<std::int64_t>(NumberType::int64);
    check_type<std::uint64_t>(NumberType::uint64);
    check_type<float>(NumberType::float32);
    check_type<double>(NumberType::float64);
}

TEST_CASE("numbers written as text come out, with their lines") {
    const auto stream = text_numbers(dsc::io::TextScanner("f", "1 2.5\n-3 x"));
    CHECK(stream->next() == 1);
    CHECK(stream->coordinate() == 2.5);
    CHECK_THROWS_WITH(stream->require_end(), Catch::Contains("there are more numbers than announced"));
    CHECK(stream->whole("a label") == -3);
    CHECK_THROWS_WITH(stream->next(), Catch::StartsWith("f: line 2: \"x\" where a number is expected"));
}

TEST_CASE("what is not finite or not whole is refused with its number") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<double> values = {1, nan, inf, 0.5, 1e300, 7};
    const std::string bytes = image(values, std::endian::little);
    const auto coordinates = doubles(values, bytes);
    CHECK(coordinates->coordinate() == 1);
    CHECK_THROWS_WITH(coordinates->coordinate(), "f: number 2 of x: a coordinate is not a finite number; correct it");
    CHECK_THROWS_AS(coordinates->coordinate(), InputError);
    CHECK(coordinates->coordinate() == 0.5);
    const auto labels = doubles(values, bytes);
    CHECK(labels->whole("a label") == 1);
    for (int i = 0; i < 4; ++i) CHECK_THROWS_WITH(labels->whole("a label"), Catch::Contains("a label is not a whole"));
    CHECK(labels->whole("a label") == 7);
    const auto ended = doubles(values, bytes.substr(0, 47));
    CHECK_THROWS_WITH(ended->next(), Catch::Contains("the data ends behind this number or is damaged"));
    const auto unread = doubles(values, bytes);
    unread->skip(5);
    CHECK_THROWS_WITH(unread->require_end(), Catch::Contains("there are more numbers than announced"));
}
