// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/smoothing.h"

#include <algorithm>
#include <limits>

#include "dsc3d/operations/max_min_step.h"

namespace dsc::dsc3d {

void Smoothing::gather_link(const RatedMesh& mesh, VertexId v, std::span<const TetId> star) {
    const Complex& complex = mesh.complex();
    link_.clear();
    qualities_.clear();
    for (const TetId t : star) {
        // The induced face looks outwards, so that [v, face] is positive.
        const FaceVertices face = complex.oriented_face(t, complex.index_of(t, v));
        link_.push_back({mesh.position(face[0]), mesh.position(face[1]), mesh.position(face[2])});
        qualities_.push_back(mesh.quality(t));
    }
}

// The worst quality of the star with v at x; any value at or below `enough` when it is not above that.
double Smoothing::rate_link(const RatedMesh& mesh, const Point3& x, double enough) {
    double least = std::numeric_limits<double>::infinity();
    qualities_.resize(link_.size());
    for (std::size_t i = 0; i < link_.size() && least > enough; ++i) {
        qualities_[i] = geometry::quality(mesh.measure(), x, link_[i][0], link_[i][1], link_[i][2], mesh.bias());
        least = std::min(least, qualities_[i]);
    }
    return least;
}

// The functions that can hold the minimum within a step, at x where `worst` is the minimum.
void Smoothing::gather_terms(const RatedMesh& mesh, VertexId v, const Point3& x, double worst) {
    terms_.clear();
    std::array<geometry::QualityTerm, 6> of_tet;
    const double highest = worst + parameters_.reach;
    const bool is_bound = mesh.surface().motion(v) != VertexMotion::free;
    for (std::size_t i = 0; i < link_.size(); ++i) {
        if (qualities_[i] > highest) continue;
        const int count =
            geometry::quality_terms(mesh.measure(), x, link_[i][0], link_[i][1], link_[i][2], of_tet, mesh.bias());
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
            if (of_tet[k].value > highest) continue;
            if (is_bound) of_tet[k].gradient = mesh.surface().allowed(v, of_tet[k].gradient);
            terms_.push_back(of_tet[k]);
        }
    }
}

// A step along the steepest term has the length asked for.
double Smoothing::first_scale(const Point3& x) const {
    double length = 0, steepest = 0;
    for (const Triangle& face : link_) length += (face[0] - x).norm() + (face[1] - x).norm() + (face[2] - x).norm();
    length /= 3 * static_cast<double>(link_.size());
    for (const geometry::QualityTerm& term : terms_) steepest = std::max(steepest, term.gradient.norm());
    return parameters_.first_step * length / std::max(steepest, 1e-300);
}

Point3 Smoothing::best_place(const RatedMesh& mesh, VertexId v, std::span<const TetId> star, double* quality) {
    Point3 x = mesh.position(v);
    double value = mesh.worst_quality(star);
    if (quality != nullptr) *quality = value;
    const VertexMotion motion = mesh.surface().motion(v);
    if (motion == VertexMotion::fixed || value <= 0) return x;
    gather_link(mesh, v, star);
    // Of a tetrahedron that is all rounding error even the sign depends on which vertex comes first.
    if (value <= least_surface_quality && (motion != VertexMotion::free || rate_link(mesh, x, 0) <= 0)) return x;
    gather_terms(mesh, v, x, value);
    if (terms_.empty()) return x;
    double s = first_scale(x);
    for (int step = 0; step < parameters_.max_steps; ++step) {
        const MaxMinStep next = max_min_step(terms_, s);
        const double predicted_gain = next.predicted - value;
        if (predicted_gain < parameters_.least_gain * value) break;
        const Point3 there = mesh.surface().settled(v, x + next.step);
        const double found = rate_link(mesh, there, value);
        if (found < value + parameters_.accepted_share * predicted_gain) {
            s *= 0.2;
            continue;
        }
        if (found > value + 0.5 * predicted_gain) s *= 3;
        x = there;
        value = found;
        gather_terms(mesh, v, x, value);
        if (terms_.empty()) break;
    }
    if (quality != nullptr) *quality = value;
    return x;
}

bool Smoothing::smooth(RatedMesh& mesh, VertexId v) {
    if (mesh.surface().motion(v) == VertexMotion::fixed) return false;
    const std::span<const TetId> star = mesh.walker().star(v);
    const double before = mesh.worst_quality(star);
    double after = before;
    const Point3 place = best_place(mesh, v, star, &after);
    return after > before * (1 + parameters_.least_gain) && mesh.surface().has_room(v, place) &&
           mesh.move(v, place, star);
}

}  // namespace dsc::dsc3d
