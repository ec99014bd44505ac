// SPDX-License-Identifier: GPL-3.0-or-later
// The length that edges of a surface should have, vertex by vertex: the same everywhere, by curvature, by the thickness
// of what is enclosed, by a function of the user, or the least of several of them; never rising faster than `gradation`
// along the edges.
// Source: thesis 4.3.2.2 (splits and collapses); gradation: Borouchaki, Hecht, Frey (1998), "Mesh gradation control".
// Guarantee: within [min_length, length]; the limit of the gradation only makes lengths smaller, and as little as it
// can. Cost: n log n.
//
//     surface::SizingParameters sizing{.length = 0.05, .min_length = 0.01};
//     sizing.edges_across = 2;
//     const std::vector<double> wanted = surface::wanted_lengths(data, sizing);
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/surface_data.h"
#include "surface/one_ring.h"

namespace dsc::surface {

struct SizingParameters {
    /// Largest wanted length. No default; > 0.
    double length = 0;
    /// Smallest wanted length. No default unless sizing is uniform; in (0, length].
    double min_length = 0;
    /// By curvature: how far the surface may turn along one edge [degree]. In (0, 90].
    std::optional<double> max_turn;
    /// By thickness: how many edges should fit across. > 0.
    std::optional<double> edges_across;
    /// By the user: the wanted length at a place. Has to be positive there.
    std::function<double(const Point3&)> field;
    /// By how much wanted lengths may differ along an edge [its length]. > 0.
    double gradation = 0.3;

    bool is_uniform() const { return !max_turn && !edges_across && !field; }
    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// The wanted length at each vertex. Throws core::UsageError when the user's field is not positive at a vertex.
std::vector<double> wanted_lengths(const geometry::SurfaceData& surface, const SizingParameters& parameters);

/// Length of an edge along which a surface turns by `max_turn` [rad], by the larger principal curvature at each vertex;
/// infinite in planes.
std::vector<double> lengths_by_curvature(const geometry::SurfaceData& surface, double max_turn);

/// Lowers `lengths` until they differ by at most `gradation` times the length of the edge along every edge.
void limit_gradation(const geometry::SurfaceData& surface, double gradation, std::span<double> lengths);

}  // namespace dsc::surface
