// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/step_record.h"

#include <algorithm>
#include <numbers>

#include "apps/flow/kept_share.h"
#include "geometry/triangle.h"

namespace dsc::flow::planar {

using core::EdgeId;
using core::FaceId;
using core::VertexId;
using dsc2d::Complex;

namespace {

void judge_triangles(const Complex& complex, StepRecord& record) {
    double least = std::numbers::pi, greatest = 0;
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        if (complex.is_deleted(FaceId(i))) continue;
        const auto [a, b, c] = complex.corners(FaceId(i));
        record.inverted += geometry::is_counterclockwise(a, b, c) ? 0 : 1;
        least = std::min(least, geometry::min_angle(a, b, c));
        greatest = std::max(greatest, geometry::max_angle(a, b, c));
    }
    record.min_angle = least * 180 / std::numbers::pi;
    record.max_angle = greatest * 180 / std::numbers::pi;
}

}  // namespace

UnchangedEdges::UnchangedEdges(const Complex& complex) : number_(complex.vertex_attributes(), 0) {
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) number_[VertexId(i)] = i + 1;
    first_ = numbered_edges(complex);
}

UnchangedEdges::UnchangedEdges(const Complex& complex, const State& state)
    : number_(complex.vertex_attributes(), 0), first_(state.first) {
    for (std::uint32_t i = 0; i < state.numbers.size(); ++i) number_[VertexId(i)] = state.numbers[i];
}

UnchangedEdges::State UnchangedEdges::state() const {
    return {.numbers = {number_.values().begin(), number_.values().end()}, .first = first_};
}

std::vector<UnchangedEdges::Key> UnchangedEdges::numbered_edges(const Complex& complex) const {
    std::vector<Key> keys;
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        const EdgeId e(i);
        if (complex.is_deleted(e) || !complex.is_interface(e)) continue;
        const std::uint32_t a = number_[complex.from(Complex::halfedge(e))];
        const std::uint32_t b = number_[complex.to(Complex::halfedge(e))];
        keys.push_back({std::min(a, b), std::max(a, b)});
    }
    std::ranges::sort(keys);
    return keys;
}

double UnchangedEdges::share(const Complex& complex) const { return kept_share(first_, numbered_edges(complex)); }

StepRecord step_record(const Complex& complex, int step, double time, const UnchangedEdges& unchanged) {
    StepRecord record{.step = step, .time = time};
    record.vertices = complex.vertex_count();
    record.triangles = complex.face_count();
    record.unchanged_share = unchanged.share(complex);
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i)
        record.interface_edges += !complex.is_deleted(EdgeId(i)) && complex.is_interface(EdgeId(i)) ? 1 : 0;
    record.labels = dsc2d::label_statistics(complex);
    judge_triangles(complex, record);
    return record;
}

void add_step(StepRecord& record, const Complex& complex, const motion::StepReport<2>& report) {
    record.is_complete = report.is_complete;
    record.substeps = report.substeps;
    for (const auto& motion : report.unfinished)
        record.unfinished.push_back({complex.position(motion.vertex), motion.remaining, motion.is_locked});
    record.counts = report.counts;
}

}  // namespace dsc::flow::planar
