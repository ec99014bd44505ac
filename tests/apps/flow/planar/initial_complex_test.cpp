// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/initial_complex.h"

#include <catch2/catch.hpp>

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
        const dsc2d::Parameters parameters = deformation(initial, motion::TopologyPolicy::adaptive);
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

TEST_CASE("a labelled planar mesh is taken as it is; without labels, or without being one, it is refused") {
    const tests::TemporaryFolder folder;
    const std::string path = (folder / "a.mesh").string();
    geometry::SurfaceData data;
    for (int j = 0; j <= 4; ++j)
        for (int i = 0; i <= 4; ++i) data.vertices.emplace_back(i, j, 0);
    for (std::uint32_t j = 0; j < 4; ++j)
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = i + 5 * j;
            data.triangles.push_back({a, a + 1, a + 6});
            data.triangles.push_back({a, a + 6, a + 5});
        }
    io::write_planar_mesh(path, data);
    const ShapeOptions options{.shape = Shape::file, .path = path};
    CHECK_THROWS_WITH(initial_complex(options), Catch::Contains("same label") && Catch::Contains("a.mesh"));
    for (const auto& triangle : data.triangles) data.labels.push_back(data.vertices[triangle[0]].x() < 2 ? 1 : 2);
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
