// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/initial_complex.h"

#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <optional>

#include "core/errors.h"
#include "dsc2d/interface.h"
#include "dsc2d/label_statistics.h"
#include "dsc2d/validate.h"
#include "io/atomic_file.h"
#include "io/planar_mesh.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow::planar;

TEST_CASE("every shape by name has a valid mesh of good angles with its defaults, and room to turn") {
    struct Expected {
        Shape shape;
        std::size_t labels;
        std::int64_t components, holes;  ///< of label 1
    };
    for (const auto& [shape, labels, components, holes] :
         {Expected{Shape::disc, 2, 1, 0}, Expected{Shape::two_discs, 2, 2, 0}, Expected{Shape::ring, 2, 1, 1},
          Expected{Shape::dumbbell, 2, 1, 0}, Expected{Shape::slotted_disc, 2, 1, 0}, Expected{Shape::polygon, 2, 1, 0},
          Expected{Shape::box, 2, 1, 0}, Expected{Shape::labelled_block, 4, 1, 0}}) {
        CAPTURE(static_cast<int>(shape));
        const InitialComplex initial = initial_complex({.shape = shape});
        CHECK(validate(initial.complex).empty());
        const auto statistics = dsc2d::label_statistics(initial.complex);
        REQUIRE(statistics.size() == labels);
        CHECK(statistics[1].components == components);
        CHECK(statistics[1].holes == holes);
        double area = 0;
        for (const auto& label : statistics) area += label.area;
        CHECK(area == Approx(initial.domain.volume()).epsilon(1e-12));
        // Detail control has nothing to do at the start.
        const dsc2d::Parameters parameters = deformation(edge_limits(initial), motion::TopologyPolicy::adaptive);
        CHECK_NOTHROW(parameters.validate());
        for (const auto& s : dsc2d::Interface(initial.complex).segments) {
            REQUIRE(s.vector.norm() < *parameters.interface_max_edge * initial.edge_length);
            REQUIRE(s.vector.norm() > *parameters.interface_min_edge * initial.edge_length);
        }
    }
}

TEST_CASE("polygons from a file are kept, their long sides divided") {
    const tests::TemporaryFolder folder;
    io::write_file(folder / "square.csv", "10,10\n12,10\n12,12\n10,12\n");
    const ShapeOptions options{.shape = Shape::file, .path = (folder / "square.csv").string(), .edge_length = 0.1};
    const InitialComplex initial = initial_complex(options);
    CHECK(initial.domain.contains(Point2(9.1, 9.1)));
    CHECK(dsc2d::Interface(initial.complex).segments.size() == 80);
    CHECK(dsc2d::labelled_area(initial.complex, 1) == Approx(4).epsilon(1e-13));
    ShapeOptions small = options;
    small.domain = Eigen::AlignedBox2d(Point2(0, 0), Point2(11, 13));
    CHECK_THROWS_WITH(initial_complex(small), Catch::Contains("leaves the box") && Catch::Contains("(11, 10)"));
}

TEST_CASE("a shape that its coordinates can't resolve is refused by name; one that lies far away is the same there") {
    const tests::TemporaryFolder folder;
    const std::string path = (folder / "square.csv").string();
    const auto moved = [&](const std::string& offset) {
        const auto row = [&](int x, int y) {
            return offset + std::to_string(x) + "," + offset + std::to_string(y) + "\n";
        };
        io::write_file(path, row(1, 1) + row(3, 1) + row(3, 3) + row(1, 3));
        return initial_complex({.shape = Shape::file, .path = path, .edge_length = 0.25});
    };
    CHECK_THROWS_WITH(moved("100000000000000"), Catch::Contains("square.csv") && Catch::Contains("too small"));
    CHECK(dsc2d::labelled_area(moved("10000000").complex, 1) == 4);
}

namespace {

// Squares of side 1 with a diagonal each, where `label` gives one, with vertices at whole numbers.
geometry::SurfaceData squares(int columns, int rows, const std::function<std::optional<int>(int, int)>& label) {
    geometry::SurfaceData data;
    std::map<std::pair<int, int>, std::uint32_t> number;
    const auto vertex = [&](int i, int j) {
        const auto [at, is_new] = number.try_emplace({i, j}, static_cast<std::uint32_t>(data.vertices.size()));
        if (is_new) data.vertices.emplace_back(i, j, 0);
        return at->second;
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            if (!label(i, j)) continue;
            const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
            data.triangles.push_back({a, b, c});
            data.triangles.push_back({a, c, d});
            data.labels.insert(data.labels.end(), 2, *label(i, j));
        }
    return data;
}

InitialComplex complex_of(const geometry::SurfaceData& data) {
    const tests::TemporaryFolder folder;
    io::write_planar_mesh(folder / "a.mesh", data);
    return initial_complex({.shape = Shape::file, .path = (folder / "a.mesh").string()});
}

}  // namespace

TEST_CASE("a planar mesh has to fill the box that is its domain, once") {
    const auto check_refused = [](const geometry::SurfaceData& data, const std::string& place) {
        CHECK_THROWS_AS(complex_of(data), core::InputError);
        CHECK_THROWS_WITH(complex_of(data), Catch::Contains("a.mesh: " + place));
    };
    const auto striped = [](int i) { return std::optional(i % 2); };
    const geometry::SurfaceData whole = squares(6, 4, [&](int i, int) { return striped(i); });
    CHECK(complex_of(whole).complex.face_count() == 48);
    // L: a corner is missing; then the middle, and all of a row.
    check_refused(squares(6, 4, [&](int i, int j) { return i > 3 && j > 1 ? std::nullopt : striped(i); }),
                  "edge from (5, 2) to (4, 2): the mesh ends here");
    check_refused(squares(6, 4, [&](int i, int j) { return i == 2 && j == 1 ? std::nullopt : striped(i); }),
                  "edge from (3, 1) to (2, 1): the mesh ends here");
    check_refused(squares(6, 4, [&](int i, int j) { return j == 2 ? std::nullopt : striped(i); }),
                  "edge from (1, 2) to (0, 2): the mesh ends here");
    // Two whole boxes, one over the other.
    geometry::SurfaceData twice = whole;
    twice.vertices.insert(twice.vertices.end(), whole.vertices.begin(), whole.vertices.end());
    for (auto triangle : whole.triangles) {
        for (std::uint32_t& v : triangle) v += static_cast<std::uint32_t>(whole.vertices.size());
        twice.triangles.push_back(triangle);
    }
    twice.labels.insert(twice.labels.end(), whole.labels.begin(), whole.labels.end());
    check_refused(twice, "its triangles overlap: their area is 48");
    // Two labels that nowhere meet are not said to be one.
    geometry::SurfaceData apart;
    apart.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
    apart.triangles = {{0, 1, 2}, {3, 4, 5}};
    apart.labels = {1, 2};
    check_refused(apart, "edge from (1, 0) to (1, 1)");
    // Two triangles that share a corner.
    apart.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
    apart.triangles = {{0, 1, 2}, {0, 3, 4}};
    check_refused(apart, "complex: vertex 0: joins triangles");
    // On a line along an axis there is no box at all.
    for (auto& p : apart.vertices) p.y() = 7;
    check_refused(apart, "all vertices lie on a line");
    geometry::SurfaceData repeated = whole;
    repeated.triangles.push_back(whole.triangles[3]);
    repeated.labels.push_back(0);
    check_refused(repeated, "complex: triangle 48: lies on the same side");
    // The sides of a box are where they are to rounding only.
    geometry::SurfaceData rounded = whole;
    for (auto& p : rounded.vertices) p *= 0.1;
    for (std::size_t i = 0; i < rounded.vertices.size(); i += 2) rounded.vertices[i] *= 1 + 0x1p-52;
    CHECK(complex_of(rounded).complex.face_count() == 48);
    geometry::SurfaceData mirrored = whole;
    for (auto& p : mirrored.vertices) p.x() = -p.x();
    CHECK(dsc2d::labelled_area(complex_of(mirrored).complex, 1) == 12);
}

TEST_CASE("a labelled planar mesh is taken as it is; without labels, or without being one, it is refused") {
    const tests::TemporaryFolder folder;
    const std::string path = (folder / "a.mesh").string();
    geometry::SurfaceData data = squares(4, 4, [](int, int) { return 1; });
    io::write_planar_mesh(path, data);
    const ShapeOptions options{.shape = Shape::file, .path = path};
    CHECK_THROWS_WITH(initial_complex(options), Catch::Contains("same label") && Catch::Contains("a.mesh"));
    data = squares(4, 4, [](int i, int) { return i < 2 ? 1 : 2; });
    io::write_planar_mesh(path, data);
    const InitialComplex initial = initial_complex(options);
    CHECK(initial.complex.face_count() == 32);
    CHECK(initial.edge_length == 1);
    CHECK(dsc2d::labelled_area(initial.complex, 2) == 8);
    ShapeOptions torus = options;
    torus.is_torus = true;
    CHECK_THROWS_AS(initial_complex(torus), core::UsageError);
    std::swap(data.triangles[3][0], data.triangles[3][1]);
    io::write_planar_mesh(path, data);
    CHECK_THROWS_WITH(initial_complex(options), Catch::Contains("triangle 3") && Catch::Contains("a.mesh"));
}
