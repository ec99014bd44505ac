// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtp.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <sstream>

#include "core/errors.h"
#include "core/random.h"
#include "io/atomic_file.h"
#include "tests/support/seed.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/xml.h"

using namespace dsc::io;
using dsc::tests::parse_xml;
using dsc::tests::XmlElement;

namespace {

std::string decoded_base64(const std::string& text) {
    static const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : text) {
        const std::size_t value = alphabet.find(c);
        if (value == std::string::npos) continue;
        group = group << 6 | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255);
    }
    return bytes;
}

template <class T>
std::vector<T> values_of(const XmlElement& array) {
    std::vector<T> values;
    if (array.attributes.at("format") == "ascii") {
        std::istringstream text(array.text);
        for (std::string word; text >> word;) values.push_back(static_cast<T>(std::strtold(word.c_str(), nullptr)));
        return values;
    }
    const std::string bytes = decoded_base64(array.text);
    std::uint64_t size = 0;
    REQUIRE(bytes.size() >= sizeof size);
    std::memcpy(&size, bytes.data(), sizeof size);
    REQUIRE(bytes.size() == sizeof size + size);
    values.resize(size / sizeof(T));
    if (size > 0) std::memcpy(values.data(), bytes.data() + sizeof size, size);
    return values;
}

const XmlElement& array_named(const XmlElement& parent, const std::string& name) {
    for (const XmlElement* array : parent.all("DataArray")) {
        if (array->attributes.at("Name") == name) return *array;
    }
    throw std::runtime_error("no array " + name);
}

PolyData random_polygons(dsc::core::Random& random, std::size_t count) {
    PolyData data;
    VtkData distance{.name = "distance <&>", .values = {}};
    for (std::size_t i = 0; i < count; ++i) {
        data.points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1e-9, 1e-9));
        distance.values.push_back(random.uniform());
    }
    data.dots = {0};
    data.lines = {{0, 1, 2, 0}, {2, 1}};
    data.polygons = {{0, 1, 2}};
    data.point_data = {distance};
    data.cell_data = {{.name = "label", .components = 2, .values = {1, 2, 3, 4, 5, 6, 7, 8}}};
    return data;
}

}  // namespace

TEST_CASE("base64 of known texts") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
}

TEST_CASE("a VTP file holds the same numbers in both encodings") {
    dsc::core::Random random(dsc::tests::seed(4));
    for (const VtkEncoding encoding : {VtkEncoding::binary, VtkEncoding::ascii}) {
        const PolyData data = random_polygons(random, 3 + random.below(50));
        const XmlElement file = parse_xml(vtp_text(data, encoding));
        CHECK(file.attributes.at("type") == "PolyData");
        const XmlElement& piece = *file.all("Piece").at(0);
        CHECK(piece.attributes.at("NumberOfPoints") == std::to_string(data.points.size()));
        CHECK(piece.attributes.at("NumberOfLines") == "2");

        const std::vector<double> coordinates = values_of<double>(array_named(piece, "Points"));
        REQUIRE(coordinates.size() == 3 * data.points.size());
        CHECK(std::memcmp(coordinates.data(), data.points.data(), coordinates.size() * sizeof(double)) == 0);
        CHECK(values_of<double>(array_named(piece, "distance <&>")) == data.point_data[0].values);
        CHECK(values_of<double>(array_named(piece, "label")) == data.cell_data[0].values);

        const XmlElement& lines = *piece.all("Lines").at(0);
        CHECK(values_of<std::int64_t>(array_named(lines, "connectivity")) ==
              std::vector<std::int64_t>{0, 1, 2, 0, 2, 1});
        CHECK(values_of<std::int64_t>(array_named(lines, "offsets")) == std::vector<std::int64_t>{4, 6});
        CHECK(values_of<std::int64_t>(array_named(*piece.all("Polys").at(0), "offsets")) ==
              std::vector<std::int64_t>{3});
    }
}

TEST_CASE("nothing at all is a valid VTP file") { CHECK_NOTHROW(parse_xml(vtp_text({}))); }

TEST_CASE("the index of a series is complete after every step") {
    const dsc::tests::TemporaryFolder folder;
    dsc::core::Random random(1);
    PvdSeries series(folder / "fronts", "front");
    for (int step = 0; step < 3; ++step) {
        series.add(0.1 * step, random_polygons(random, 5));
        const XmlElement index = parse_xml(read_file(series.index()));
        const auto entries = index.all("DataSet");
        REQUIRE(entries.size() == static_cast<std::size_t>(step + 1));
        CHECK(std::stod(entries.back()->attributes.at("timestep")) == 0.1 * step);
        CHECK(std::filesystem::exists(folder / "fronts" / entries.back()->attributes.at("file")));
    }
    CHECK_THROWS_AS(PvdSeries(folder / "a/b", "x"), dsc::core::InputError);
}
