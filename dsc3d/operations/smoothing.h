// SPDX-License-Identifier: GPL-3.0-or-later
// Optimization-based smoothing: a vertex moves to where the worst tetrahedron of its star is best: anywhere inside a
// region, within a flat patch of the surface, or along a straight ridge.
// Source: Freitag, Jones, Plassmann (thesis 3.2.1); the non-smooth max-min problem is solved by proximal bundle steps
// (max_min_step.h), which follow the creases where steepest ascent jams.
// Guarantee: the worst quality of the star increases, or nothing is changed. Cost: some 10 us per step.
#pragma once

#include <vector>

#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

struct SmoothingParameters {
    int max_steps = 12;           ///< accepted and refused ones
    double least_gain = 0.0125;   ///< smaller gains are not worth a step, relative to the worst quality
    double first_step = 0.1;      ///< length of the first step, in mean edge lengths of the star
    double accepted_share = 0.1;  ///< of the predicted gain that a step has to bring
    double reach = 0.25;          ///< tetrahedra better than the worst one by more are left out of a step's model
};

class Smoothing {
public:
    explicit Smoothing(const SmoothingParameters& parameters = {}) : parameters_(parameters) {}

    /// True when the vertex was moved.
    bool smooth(RatedMesh& mesh, VertexId v);

    /// The best place found for v, without moving it; the star is that of v. Its worst quality there, if wanted.
    Point3 best_place(const RatedMesh& mesh, VertexId v, std::span<const TetId> star, double* quality = nullptr);

private:
    using Triangle = std::array<Point3, 3>;

    void gather_link(const RatedMesh& mesh, VertexId v, std::span<const TetId> star);
    double rate_link(const RatedMesh& mesh, const Point3& x, double enough);
    void gather_terms(const RatedMesh& mesh, VertexId v, const Point3& x, double worst);
    double first_scale(const Point3& x) const;

    SmoothingParameters parameters_;
    std::vector<Triangle> link_;  ///< with x before them, the tetrahedra of the star, positive
    std::vector<double> qualities_;
    std::vector<geometry::QualityTerm> terms_;
};

}  // namespace dsc::dsc3d
