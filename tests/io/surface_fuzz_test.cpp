// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files of surfaces and points: each gives a valid result or core::InputError with one line, never anything
// else.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>

#include "core/random.h"
#include "tests/geometry/surfaces.h"
#include "tests/io/surface/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::tests;
using core::Random;

namespace {

constexpr int kinds = 7;

// The digits behind a place up to `limit`; empty when there are none.
std::pair<std::size_t, std::size_t> number_behind(const std::string& text, std::size_t begin, std::size_t limit) {
    const auto is_digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(text[i])) != 0; };
    while (begin < limit && !is_digit(begin)) ++begin;
    std::size_t end = begin;
    while (end < limit && is_digit(end)) ++end;
    return {begin, end - begin};
}

std::string damaged(std::string text, int kind, Random& random) {
    const std::size_t place = random.below(text.size());
    const std::size_t line_end = std::min(text.find('\n', place), text.size() - 1) + 1;
    switch (kind) {
        case 0: text[place] ^= static_cast<char>(1 << random.below(8)); break;
        case 1: text.resize(place); break;
        case 2: text.erase(place, line_end - place); break;
        case 3: text.insert(line_end, text.substr(place, line_end - place)); break;
        case 4: {  // a number out of all bounds
            static const char* const numbers[] = {
                "-1",  "0",     "4294967295", "99999999", "9223372036854775807", "nan",
                "1e9", "1e999", "-0",         "0.5",      "18446744073709551615"};
            const auto [begin, size] = number_behind(text, place, text.size());
            text.replace(begin, size, numbers[random.below(std::size(numbers))]);
            break;
        }
        case 5: {  // a number in the first lines, where the counts are
            const std::size_t limit = std::min<std::size_t>(text.size(), 300);
            const auto [begin, size] = number_behind(text, random.below(limit), limit);
            text.replace(begin, size, std::to_string(random.below(2) == 0 ? ~0U : random.below(99)));
            break;
        }
        default:  // a binary word out of all bounds
            for (std::size_t i = place; i < std::min(place + 8, text.size()); ++i) text[i] = '\xff';
    }
    return text;
}

std::string ascii_ply(const geometry::SurfaceData& data) {
    const auto text = [](const auto& values) {
        std::string row;
        for (const auto x : values) row += std::to_string(x) + " ";
        return row + "\n";
    };
    std::string file = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(data.vertices.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(data.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3d& p : data.vertices) file += text(p);
    for (const auto& triangle : data.triangles) file += "3 " + text(triangle);
    return file;
}

std::string ascii_stl(const geometry::SurfaceData& data) {
    std::string file = "solid\n";
    for (const auto& triangle : data.triangles) {
        file += "facet normal 0 0 1\nouter loop\n";
        for (const std::uint32_t v : triangle) {
            file += "vertex";
            for (const double x : data.vertices[v]) file += " " + std::to_string(x);
            file += "\n";
        }
        file += "endloop\nendfacet\n";
    }
    return file + "endsolid\n";
}

std::string xyz(const geometry::SurfaceData& data) {
    std::string file;
    for (const Eigen::Vector3d& p : data.vertices) {
        for (const double x : p) file += std::to_string(x) + " ";
        file += "0 0 1\n";
    }
    return file;
}

bool are_finite(const std::vector<Eigen::Vector3d>& points) {
    return std::ranges::all_of(points, [](const Eigen::Vector3d& p) { return p.allFinite(); });
}

void check_valid(const geometry::SurfaceData& data) {
    CHECK_FALSE(data.triangles.empty());
    CHECK((data.labels.empty() || data.labels.size() == data.triangles.size()));
    CHECK(are_finite(data.vertices));
    CHECK(std::ranges::all_of(data.triangles, [&](std::array<std::uint32_t, 3> triangle) {
        std::ranges::sort(triangle);
        return std::ranges::adjacent_find(triangle) == triangle.end() && triangle[2] < data.vertices.size();
    }));
}

void check_valid(const geometry::PointData& data) {
    CHECK_FALSE(data.points.empty());
    CHECK((data.normals.empty() || data.normals.size() == data.points.size()));
    CHECK(are_finite(data.points));
    CHECK(are_finite(data.normals));
}

struct Outcomes {
    int errors = 0;
    int results = 0;

    template <class Read>
    void add(const std::filesystem::path& path, const Read& read) {
        try {
            check_valid(read(path));
            ++results;
        } catch (const core::InputError& error) {
            const std::string message = error.what();
            CHECK(message.find('\n') == message.npos);
            CHECK(message.starts_with(path.parent_path().string()));
            ++errors;
        }
    }
};

}  // namespace

TEST_CASE("a damaged file of a surface or of points gives valid data or an error of one line") {
    Random random(seed(85));
    const TemporaryFolder folder;
    geometry::SurfaceData data = joined(box(), torus(4, 0.3));
    data.labels.assign(data.triangles.size(), 3);
    for (const char* name : {"s.off", "s.obj", "s.ply", "s.stl"}) io::write_surface_mesh(folder / name, data);
    io::write_file(folder / "ascii.ply", ascii_ply(data));
    io::write_file(folder / "ascii.stl", ascii_stl(data));
    io::write_file(folder / "p.xyz", xyz(data));
    Outcomes surfaces, points;
    for (const char* name : {"s.off", "s.obj", "s.ply", "s.stl", "ascii.ply", "ascii.stl", "p.xyz"}) {
        const std::string whole = io::read_file(folder / name);
        for (int i = 0; i < 8 * kinds; ++i) {
            CAPTURE(name, i);
            io::write_file(folder / name, damaged(whole, i % kinds, random));
            const bool is_stl = std::string_view(name).ends_with("stl");
            if (!is_stl) points.add(folder / name, io::read_points);
            if (std::string_view(name) != "p.xyz") surfaces.add(folder / name, io::read_surface_mesh);
        }
    }
    for (const Outcomes& outcomes : {surfaces, points}) {
        CHECK(outcomes.errors > 50);
        CHECK(outcomes.results > 10);
    }
}
