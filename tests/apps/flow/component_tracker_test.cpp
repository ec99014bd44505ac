// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/component_tracker.h"

#include <catch2/catch.hpp>
#include <set>

#include "apps/flow/step_record.h"
#include "dsc3d/operations/split.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"

using namespace dsc;
using namespace dsc::flow;
using namespace dsc::tests;

namespace {

/// Cubes of six tetrahedra in a row, all of label 0.
struct Row {
    Row() : mesh(box({7, 1, 1})) {}
    void label_cube(int cube, int label) {
        for (const core::TetId t : tets(mesh.complex()))
            if (static_cast<int>(Tets::centroid(mesh, t).x()) == cube) mesh.complex().set_label(t, label);
    }
    dsc3d::Mesh mesh;
};

}  // namespace

TEST_CASE("a component whose last tetrahedron is relabelled has vanished, once") {
    Row row;
    row.label_cube(1, 1);
    row.label_cube(5, 1);
    ComponentTracker<Tets> tracker(row.mesh);
    CHECK(tracker.update(row.mesh).empty());
    row.label_cube(5, 0);
    const auto vanished = tracker.update(row.mesh);
    // The parts of label 0 that it has joined are still there.
    REQUIRE(vanished.size() == 1);
    CHECK(vanished[0].label == 1);
    CHECK(static_cast<int>(vanished[0].centroid.x()) == 5);
    CHECK(tracker.update(row.mesh).empty());
}

TEST_CASE("what splits, and what gets other tetrahedra only, has not vanished") {
    Row row;
    for (int cube = 1; cube < 4; ++cube) row.label_cube(cube, 1);
    ComponentTracker<Tets> tracker(row.mesh);
    row.label_cube(2, 0);
    CHECK(tracker.update(row.mesh).empty());  // it is two components now

    // All tetrahedra of cube 1 are replaced.
    for (const core::TetId t : tets(row.mesh.complex()))
        if (row.mesh.complex().label(t) == 1 && Tets::centroid(row.mesh, t).x() < 2)
            split(row.mesh, t, Tets::centroid(row.mesh, t));
    CHECK(tracker.update(row.mesh).empty());
}

TEST_CASE("a label that is gone altogether is reported with each of its components") {
    Row row;
    row.label_cube(1, 3);
    row.label_cube(3, 3);
    row.label_cube(5, 3);
    ComponentTracker<Tets> tracker(row.mesh);
    for (const int cube : {1, 3, 5}) row.label_cube(cube, 0);
    std::set<int> cubes;
    for (const auto& component : tracker.update(row.mesh))
        if (component.label == 3) cubes.insert(static_cast<int>(component.centroid.x()));
    CHECK(cubes == std::set<int>{1, 3, 5});
}
