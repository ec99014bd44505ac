// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/initial_mesh.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/errors.h"
#include "dsc3d/generate/blocks.h"
#include "dsc3d/generate/lattice.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/interface.h"
#include "dsc3d/label_statistics.h"
#include "dsc3d/mesh.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow;

namespace {

dsc3d::Mesh made(const ShapeOptions& options) {
    core::Observer observer;
    const InitialMesh initial = initial_mesh(options, observer);
    const dsc3d::Mesh mesh(initial.data);
    double volume = 0;
    for (const auto& label : dsc3d::label_statistics(mesh)) volume += label.volume;
    CHECK(volume == Approx(initial.domain.volume()).epsilon(1e-12));
    return dsc3d::Mesh(initial.data);
}

}  // namespace

TEST_CASE("every shape by name has a mesh of good angles with its defaults", "[slow]") {
    struct Expected {
        Shape shape;
        std::size_t labels;
        std::int64_t components, genus;  ///< of label 1
    };
    for (const auto& [shape, labels, components, genus] :
         {Expected{Shape::sphere, 2, 1, 0}, Expected{Shape::box, 2, 1, 0}, Expected{Shape::torus, 2, 1, 1},
          Expected{Shape::dumbbell, 2, 1, 0}, Expected{Shape::slotted_cube, 2, 1, 0},
          Expected{Shape::labelled_block, 4, 1, 0}}) {
        CAPTURE(static_cast<int>(shape));
        const dsc3d::Mesh mesh = made({.shape = shape});
        CHECK(dsc3d::AngleRange(mesh).min > 15 * std::numbers::pi / 180);
        const auto statistics = dsc3d::label_statistics(mesh);
        REQUIRE(statistics.size() == labels);
        CHECK(statistics[1].components == components);
        CHECK(statistics[1].genus == genus);
    }
}

TEST_CASE("two spheres are one label, the sphere of the defaults has 1280 triangles", "[slow]") {
    const auto statistics = dsc3d::label_statistics(made({.shape = Shape::two_spheres, .gap = 0.1}));
    REQUIRE(statistics.size() == 2);
    CHECK(statistics[1].components == 2);
    CHECK(shape_surface({.shape = Shape::sphere}).surface.triangles.size() == 1280);
}

TEST_CASE("a surface from a file is kept, or remeshed to the edge length asked for") {
    const tests::TemporaryFolder folder;
    const geometry::SurfaceData cube = dsc3d::box_surface({Point3(1, 1, 1), Point3(2, 2, 2)}, 0.25);
    io::write_surface_mesh(folder / "cube.off", cube);
    const ShapeOptions options = {.shape = Shape::file, .path = (folder / "cube.off").string()};
    CHECK(dsc3d::Interface(made(options)).faces.size() == cube.triangles.size());
    ShapeOptions finer = options;
    finer.edge_length = 0.15;
    const dsc3d::Mesh mesh = made(finer);
    CHECK(dsc3d::Interface(mesh).faces.size() > 1.5 * static_cast<double>(cube.triangles.size()));
    CHECK(dsc3d::label_statistics(mesh)[1].volume == Approx(1).epsilon(1e-12));

    geometry::SurfaceData open = cube;
    open.triangles.pop_back();
    io::write_surface_mesh(folder / "open.off", open);
    core::Observer observer;
    CHECK_THROWS_WITH(initial_mesh({.shape = Shape::file, .path = (folder / "open.off").string()}, observer),
                      Catch::Contains("open edge") && Catch::Contains("open.off"));
    ShapeOptions small = options;
    small.domain = Eigen::AlignedBox3d(Point3(0, 0, 0), Point3(1.5, 3, 3));
    CHECK_THROWS_WITH(initial_mesh(small, observer), Catch::Contains("leaves the box"));
}

TEST_CASE("labelled tetrahedra from a file are taken as they are; without labels there is nothing to move") {
    const tests::TemporaryFolder folder;
    geometry::TetData data = dsc3d::lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.25);
    io::write_tet_mesh(folder / "plain.mesh", data);
    core::Observer observer;
    const ShapeOptions plain = {.shape = Shape::file, .path = (folder / "plain.mesh").string()};
    CHECK_THROWS_WITH(initial_mesh(plain, observer), Catch::Contains("label") && Catch::Contains("plain.mesh"));

    for (const auto& tet : data.tets) data.labels.push_back(data.vertices[tet[0]].z() < 0.5 ? 1 : 2);
    io::write_tet_mesh(folder / "halves.vtu", data);
    ShapeOptions halves = {.shape = Shape::file, .path = (folder / "halves.vtu").string()};
    const InitialMesh initial = initial_mesh(halves, observer);
    CHECK(initial.data.tets == data.tets);
    CHECK(initial.data.labels == data.labels);
    halves.domain = initial.domain;
    CHECK_THROWS_AS(initial_mesh(halves, observer), core::UsageError);
}

TEST_CASE("a ball as the domain is filled to its sphere, whose wall is that sphere") {
    core::Observer observer;
    ShapeOptions options = {.shape = Shape::sphere, .radius = 0.2, .edge_length = 0.1};
    options.sphere = SphericalDomain{Point3(0.5, 0.5, 0.4), 0.5};
    const InitialMesh initial = initial_mesh(options, observer);
    const dsc3d::Mesh mesh(initial.data);
    CHECK(initial.domain.center().isApprox(options.sphere->centre));
    CHECK(initial.domain.sizes().isApprox(Point3(1, 1, 1)));
    double volume = 0;
    for (const auto& label : dsc3d::label_statistics(mesh)) volume += label.volume;
    CHECK(volume == Approx(std::numbers::pi / 6).epsilon(0.01));
    const dsc3d::Walls walls = domain_walls(options);
    REQUIRE(walls.size() == 1);
    for (std::uint32_t i = 0; i < mesh.complex().vertex_capacity(); ++i) {
        const dsc3d::VertexId v(i);
        if (mesh.complex().is_boundary(v))
            REQUIRE((walls[0]->nearest(mesh.position(v)) - mesh.position(v)).norm() < 1e-14);
    }
    // The farthest vertex is at 0.3: inside the sphere, but not inside of every triangle with its vertices on it.
    for (const double radius : {0.29, 0.3003}) {
        options.sphere->radius = radius;
        CHECK_THROWS_AS(initial_mesh(options, observer), core::UsageError);
    }
    options.sphere.reset();
    CHECK(domain_walls(options).empty());
}

TEST_CASE(
    "a closed surface from a file as the domain is filled, its triangles are kept, and its curved side is a wall") {
    const tests::TemporaryFolder folder;
    const std::string path = (folder / "container.obj").string();
    const geometry::SurfaceData container = dsc3d::icosphere(Point3(0.5, 0.5, 0.4), 0.5, 6);
    io::write_surface_mesh(path, container);
    core::Observer observer;
    ShapeOptions options = {.shape = Shape::sphere, .radius = 0.2, .edge_length = 0.1, .container = path};
    const InitialMesh initial = initial_mesh(options, observer);
    const dsc3d::Mesh mesh(initial.data);
    CHECK(initial.domain.center().isApprox(Point3(0.5, 0.5, 0.4)));
    std::size_t boundary_faces = 0;
    for (std::uint32_t i = 0; i < mesh.complex().face_capacity(); ++i)
        boundary_faces += mesh.complex().is_boundary(dsc3d::FaceId(i)) ? 1 : 0;
    CHECK(boundary_faces == container.triangles.size());
    const dsc3d::Walls walls = domain_walls(options);
    REQUIRE(walls.size() == 1);
    for (const Point3& p : container.vertices) CHECK((walls[0]->nearest(p) - p).norm() < 1e-14);
    options.container = (folder / "absent.obj").string();
    CHECK_THROWS_AS(initial_mesh(options, observer), core::InputError);
}
