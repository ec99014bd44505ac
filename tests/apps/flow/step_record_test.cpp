// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/step_record.h"

#include <catch2/catch.hpp>

#include "dsc3d/generate/fit.h"
#include "dsc3d/generate/lattice.h"
#include "dsc3d/interface.h"
#include "dsc3d/operations/split.h"

using namespace dsc;
using namespace dsc::flow;

namespace {

dsc3d::Mesh ball() {
    dsc3d::Mesh mesh(dsc3d::lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.2));
    dsc3d::fit(mesh, [](const Point3& p) { return (p - Point3(0.5, 0.5, 0.5)).norm() - 0.3; });
    return mesh;
}

}  // namespace

TEST_CASE("a record has the figures of the mesh, inverted tetrahedra among them") {
    dsc3d::Mesh mesh = ball();
    const UnchangedTriangles unchanged(mesh);
    const StepRecord record = step_record(mesh, 3, 0.5, unchanged);
    CHECK(record.step == 3);
    CHECK(record.time == 0.5);
    CHECK(record.tets == mesh.complex().tet_count());
    CHECK(record.interface_faces == dsc3d::Interface(mesh).faces.size());
    CHECK(record.unchanged_share == 1);
    CHECK(record.labels.size() == 2);
    CHECK(record.inverted == 0);
    CHECK(record.min_quality > 0);
    CHECK(record.min_dihedral > 0);

    const dsc3d::VertexId v = dsc3d::Interface(mesh).vertices.front();
    mesh.set_position(v, mesh.position(v) + Point3(2, 0, 0));
    CHECK(step_record(mesh, 4, 1, unchanged).inverted > 0);
    CHECK(step_record(mesh, 4, 1, unchanged).min_quality < 0);
}

TEST_CASE("a triangle that was split is no longer unchanged, the others are") {
    dsc3d::Mesh mesh = ball();
    const UnchangedTriangles unchanged(mesh);
    const std::size_t count = dsc3d::Interface(mesh).faces.size();
    const dsc3d::FaceId face = dsc3d::Interface(mesh).faces.front();
    const dsc3d::EdgeId edge = mesh.complex().edges(face)[0];
    const auto [a, b] = mesh.complex().vertices(edge);
    dsc3d::split(mesh, edge, (mesh.position(a) + mesh.position(b)) / 2);
    CHECK(unchanged.share(mesh) == Approx(1 - 2.0 / static_cast<double>(count)));
}

TEST_CASE("motion that was not made is counted with the longest remainder") {
    motion::StepReport<3> report;
    report.is_complete = false;
    report.substeps = 7;
    report.unfinished = {{core::VertexId(1), Point3(0.1, 0, 0), false}, {core::VertexId(2), Point3(0, 0.3, 0.4), true}};
    report.counts.moves = 11;
    StepRecord record;
    add_step(record, report);
    CHECK_FALSE(record.is_complete);
    CHECK(record.substeps == 7);
    CHECK(record.unfinished == 2);
    CHECK(record.largest_remainder == Approx(0.5));
    CHECK(record.counts.moves == 11);
}
