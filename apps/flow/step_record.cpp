// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/step_record.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "apps/flow/kept_share.h"
#include "dsc3d/improve/angle_range.h"
#include "geometry/tetrahedron_quality.h"

namespace dsc::flow {

using dsc3d::Complex;
using dsc3d::FaceId;
using dsc3d::Mesh;
using dsc3d::TetId;

namespace {

void judge_tets(const Mesh& mesh, StepRecord& record) {
    const Complex& complex = mesh.complex();
    record.min_quality = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i) {
        const TetId t(i);
        if (complex.is_deleted(t)) continue;
        const auto& [a, b, c, d] = complex.vertices(t);
        record.inverted += mesh.is_positive(complex.vertices(t)) ? 0 : 1;
        record.min_quality =
            std::min(record.min_quality, geometry::quality(geometry::QualityMeasure::volume_length, mesh.position(a),
                                                           mesh.position(b), mesh.position(c), mesh.position(d)));
    }
    const dsc3d::AngleRange angles(mesh);
    record.min_dihedral = angles.min * 180 / std::numbers::pi;
    record.max_dihedral = angles.max * 180 / std::numbers::pi;
}

}  // namespace

UnchangedTriangles::UnchangedTriangles(const Mesh& mesh) : number_(mesh.complex().vertex_attributes(), 0u) {
    for (std::uint32_t i = 0; i < mesh.complex().vertex_capacity(); ++i) number_[dsc3d::VertexId(i)] = i + 1;
    first_ = numbered_triangles(mesh);
}

UnchangedTriangles::UnchangedTriangles(const Mesh& mesh, const State& state)
    : number_(mesh.complex().vertex_attributes(), 0u), first_(state.first) {
    for (std::uint32_t i = 0; i < state.numbers.size(); ++i) number_[dsc3d::VertexId(i)] = state.numbers[i];
}

UnchangedTriangles::State UnchangedTriangles::state(const Mesh& mesh) const {
    State state{.first = first_};
    for (std::uint32_t i = 0; i < mesh.complex().vertex_capacity(); ++i)
        if (!mesh.complex().is_deleted(dsc3d::VertexId(i))) state.numbers.push_back(number_[dsc3d::VertexId(i)]);
    return state;
}

std::vector<UnchangedTriangles::Key> UnchangedTriangles::numbered_triangles(const Mesh& mesh) const {
    const Complex& complex = mesh.complex();
    std::vector<Key> triangles;
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const FaceId f(i);
        if (complex.is_deleted(f) || !complex.is_interface(f)) continue;
        const dsc3d::FaceVertices v = complex.vertices(f);
        Key& key = triangles.emplace_back();
        std::ranges::transform(v, key.begin(), [&](dsc3d::VertexId vertex) { return number_[vertex]; });
        std::ranges::sort(key);
    }
    std::ranges::sort(triangles);
    return triangles;
}

double UnchangedTriangles::share(const Mesh& mesh) const { return kept_share(first_, numbered_triangles(mesh)); }

StepRecord step_record(const Mesh& mesh, int step, double time, const UnchangedTriangles& unchanged) {
    StepRecord record{.step = step, .time = time};
    const Complex& complex = mesh.complex();
    record.vertices = complex.vertex_count();
    record.tets = complex.tet_count();
    record.unchanged_share = unchanged.share(mesh);
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i)
        record.interface_faces += !complex.is_deleted(FaceId(i)) && complex.is_interface(FaceId(i)) ? 1 : 0;
    record.labels = dsc3d::label_statistics(mesh);
    judge_tets(mesh, record);
    return record;
}

void add_step(StepRecord& record, const motion::StepReport<3>& report) {
    record.is_complete = report.is_complete;
    record.substeps = report.substeps;
    record.unfinished = report.unfinished.size();
    for (const auto& motion : report.unfinished) {
        record.in_contact += motion.is_locked ? 1 : 0;
        record.largest_remainder = std::max(record.largest_remainder, motion.remaining.stableNorm());
    }
    record.counts = report.counts;
}

}  // namespace dsc::flow
