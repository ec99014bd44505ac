// SPDX-License-Identifier: GPL-3.0-or-later
// The labelled complex whose interface is the first surface: tetrahedra as fine as the cloud is dense, inside where the
// winding number of the oriented points exceeds 1/2.
// Source: thesis 4.4.3, whose front moves in from a bounding surface step by step; here it advances by labels, from the
// box inwards and past the points at once, which leaves the same kind of complex. Cells: an octree whose leaves follow
// the spacing of the points (as geometry for "Isosurface stuffing", Labelle, Shewchuk 2007), connected by Delaunay.
// Guarantee: the mesh is valid, its interface a closed manifold inside the box; regions of either label that no points
// bound are gone; the same bits on any number of threads. Cost: some 100 us per triangle of the interface.
#pragma once

#include <memory>
#include <optional>

#include "apps/reconstruct/cloud.h"
#include "apps/reconstruct/orientation.h"
#include "core/observer.h"
#include "dsc3d/mesh.h"

namespace dsc::reconstruct {

inline constexpr int outside_label = 0;
inline constexpr int inside_label = 1;

struct FrontParameters {
    double cell = 2.5;           ///< side of a leaf at the points, in their spacings; > 0
    double cells_across = 1.1;   ///< at least, through what is thin, as far as the spacing allows; > 0
    double least_cell = 1.2;     ///< ... and no smaller than this, in spacings; in (0, cell]
    double growth = 0.5;         ///< of the leaves, per distance from the points; > 0
    double margin = 0.2;         ///< of the box around the cloud, in diagonals of the cloud; > 0
    double least_support = 0.4;  ///< share of the vertices of a part's surface that have a point within a leaf; [0, 1]

    /// Throws core::UsageError naming the field.
    void validate() const;
};

struct Front {
    std::unique_ptr<dsc3d::Mesh> mesh;
    std::vector<double> cell;       ///< wanted side of a leaf at each point of the cloud
    std::size_t dropped_parts = 0;  ///< regions that no points bound
    std::size_t cavities = 0;       ///< of outside within inside, which stay

    /// Length of the edges of the interface at a point of the cloud.
    double wanted_edge(std::size_t point) const { return edge_per_cell * cell[point]; }
    static constexpr double edge_per_cell = 0.8;
};

/// `edge_length`: wanted one of the interface everywhere, instead of one that follows the spacing.
Front labelled_front(const Cloud& cloud, const Orientation& orientation, double noise,
                     std::optional<double> edge_length, const FrontParameters& parameters, core::Observer& observer);

}  // namespace dsc::reconstruct
