// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/octree_points.h"

#include <catch2/catch.hpp>

#include <algorithm>

#include "dsc3d/generate/delaunay.h"
#include "dsc3d/mesh.h"
#include "tests/apps/reconstruct/clouds.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::reconstruct;

TEST_CASE("points of an octree fill the cube, all different, and are as fine as asked for at the cloud") {
    core::Random random(tests::seed(1));
    const tests::OrientedCloud cloud = tests::sphere_cloud({0, 0, 0}, 0.3, 300, random);
    const KdTree tree(cloud.points);
    const std::vector<double> cell(cloud.points.size(), 0.08);
    std::vector<Point3> points = octree_points(tree, cell, 0.5, 0.64);
    const KdTree lattice(points);
    std::vector<KdTree::Neighbour> found;
    for (const Point3& p : cloud.points) {
        lattice.nearest(p, 1, found);
        CHECK(std::sqrt(found[0].squared_distance) < 0.08 * 1.41 * 0.87);
    }
    for (const double x : {-0.64, 0.64})
        for (const double y : {-0.64, 0.64}) CHECK(lattice.nearest({x, y, -0.64}).squared_distance < 1e-20);
    const dsc3d::Mesh mesh(dsc3d::delaunay(points));
    CHECK(dsc3d::validate(mesh).empty());
    CHECK(mesh.complex().vertex_count() == points.size());
    double volume = 0;
    const geometry::TetData data = mesh.data();
    for (const auto& [a, b, c, d] : data.tets) {
        const Point3& p = data.vertices[a];
        volume += (data.vertices[b] - p).dot((data.vertices[c] - p).cross(data.vertices[d] - p)) / 6;
    }
    CHECK(volume == Approx(std::pow(1.28, 3)));
}
