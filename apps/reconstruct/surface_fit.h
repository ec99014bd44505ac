// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the interface of a complex to the surface of a cloud: vertices to patches, to creases and to corners; edges
// that cross a crease are cut there and flipped until creases run along edges. Source: thesis 4.4.3 (planes by least
// squares, vertices to their intersections, subdivision where that does not fit); warp and cut: Labelle, Shewchuk
// (2007), here for the curves on the surface as they have it for the surface. Guarantee: the complex is valid after
// every operation, the topology of its interface stays. Cost: some 100 us per triangle and round.
#pragma once

#include <functional>

#include "apps/reconstruct/surface_model.h"
#include "apps/reconstruct/workbench.h"
#include "core/observer.h"

namespace dsc::reconstruct {

struct SurfaceFitParameters {
    int approaches = 3;         ///< rounds of moving to patches before creases are looked for; >= 1
    int rounds = 2;             ///< of claiming creases, cutting, collapsing, flipping; >= 0
    double claim_reach = 0.45;  ///< a vertex goes to a crease no farther away than this [wanted edge]; > 0
    double corner_reach = 0.8;  ///< ... or to a corner [wanted edge]; > 0
    double claim_distance =
        0.35;                  ///< ... unless a neighbour has a place on it nearer to that one's [wanted edge]; >= 0
    double cut_margin = 0.1;   ///< cuts keep this share of the edge from its ends; in (0, 0.5)
    double short_edge = 0.35;  ///< shorter edges are collapsed [wanted edge]; >= 0
    int refinements = 2;       ///< rounds of cutting edges that are off curved pieces; >= 0
    double refinement = 4e-4;  ///< by more than this in their middle [diagonal of the cloud]; > 0
    double shortest_refined = 0.7;  ///< and are longer than this [wanted edge]; > 0
    double decimation = 1.5e-4;     ///< vertices go where that moves the surface by less [diagonal of the cloud]; >= 0
    double longest_edge = 6;        ///< that decimation makes [wanted edge]; > 0

    /// Throws core::UsageError naming the field.
    void validate() const;
};

struct SurfaceFitCounts {
    std::size_t cuts = 0, collapses = 0, flips = 0, decimated = 0;
    std::size_t crease_vertices = 0, corners = 0;
};

/// Called at the end of a stage: "patches", "creases", "coarsened".
using FitWatcher = std::function<void(const char* stage)>;

/// `wanted`: length of edges at a place.
SurfaceFitCounts fit_surface(Workbench& bench, const SurfaceModel& model,
                             const std::function<double(const Point3&)>& wanted, const SurfaceFitParameters& parameters,
                             core::Observer& observer, const FitWatcher& watcher = nullptr);

}  // namespace dsc::reconstruct
