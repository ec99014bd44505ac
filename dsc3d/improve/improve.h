// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedral mesh improvement without Steiner points. Source: thesis ch. 3, algorithm 1.
// Guarantee: after every operation all tetrahedra are positive by exact predicate; the boundary and the interfaces
// between regions stay where they are within `max_boundary_change`; the quality of the worst tetrahedron never
// decreases; the same bits for the same input, parameters and seed, unless a time limit strikes.
//
//     dsc3d::Mesh mesh(data);
//     const dsc3d::ImproveReport report = dsc3d::improve(mesh, {.schedule = dsc3d::Schedule::best}, observer);
//     write(mesh.data());
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/observer.h"
#include "dsc3d/mesh.h"
#include "geometry/tetrahedron_quality.h"

namespace dsc::dsc3d {

enum class Schedule : std::uint8_t {
    thesis,  ///< algorithm 1: hill climbing by smoothing, topological pass, thinning pass
    best,    ///< the same, then escapes from local maxima around the worst tetrahedra
};

struct ImproveParameters {
    geometry::QualityMeasure measure = geometry::QualityMeasure::minimum_biased_sine;
    Schedule schedule = Schedule::thesis;
    bool uses_multi_face_retriangulation = true;
    bool uses_thinning = true;
    /// No vertex is removed or taken elsewhere, so that the numbering of the input stays, and what it says about
    /// places.
    bool keeps_vertices = false;
    bool changes_boundary = true;  ///< flat parts of the boundary may be retriangulated and smoothed
    /// Largest distance between the surface (boundary and interfaces) before and after, in diagonals of the bounding
    /// box; [0, 1e-2].
    double max_boundary_change = 1e-9;
    double feature_angle = 30;                ///< boundary edges bent by more than this are ridges [degree], (0, 180]
    std::optional<double> time_limit = {};    ///< [s]
    std::optional<double> target_angle = {};  ///< stop when all dihedral angles are in [a, 180 - a] [degree], (0, 70.5]
    std::uint64_t seed = 1;
    int threads = 0;  ///< 0: all

    /// Throws core::UsageError naming the field.
    void validate() const;
};

enum class ImproveEnd : std::uint8_t { converged, reached_target_angle, reached_time_limit, cancelled };

struct ImproveReport {
    ImproveEnd end = ImproveEnd::converged;
    double seconds = 0;
    int rounds = 0;  ///< of algorithm 1's loop
    std::size_t smoothings = 0;
    std::size_t edge_removals = 0;
    std::size_t multi_face_removals = 0;
    std::size_t multi_face_retriangulations = 0;
    std::size_t collapses = 0;
    std::size_t escapes = 0;  ///< compound changes of the schedule `best` that were kept
};

/// Improves the mesh in place; all handles change, and attributes of the caller no longer follow the mesh. On
/// cancellation the mesh is valid and the report says so. The observer's figure is the current worst quality and
/// dihedral angles.
ImproveReport improve(Mesh& mesh, const ImproveParameters& parameters, core::Observer& observer);

}  // namespace dsc::dsc3d
