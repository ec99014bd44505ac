// SPDX-License-Identifier: GPL-3.0-or-later
// The exact vertices of a cut locus: the end, branch or frontier point that each walk of the gluing goes round.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/cutlocus/cut_graph.h"
#include "apps/cutlocus/gluing.h"
#include "geodesic/meeting.h"

namespace dsc::cutlocus {

/// A vertex with one arriving geodesic per gap of the gluing.
struct SolvedVertex {
    VertexKind kind = VertexKind::branch;
    double distance = 0;
    double residual = 0;
    std::vector<int> gaps;                          ///< in the order of the walk
    std::vector<geodesic::GeodesicState> arrivals;  ///< one per gap
    std::vector<geodesic::LatticeVector> lattices;  ///< end of arrival i minus end of arrival 0, in periods

    /// Index of the arrival in `gap`, which must be one of `gaps`.
    std::size_t arrival_in(int gap) const;
};

/// An arc that no contact announced, between two vertices of one walk (indices into VertexSolution::vertices); the
/// arrivals in the two gaps are its sides.
struct UnannouncedArc {
    std::size_t start = 0, end = 0;
    int first_gap = 0, second_gap = 0;
};

struct VertexSolution {
    std::vector<SolvedVertex> vertices;
    /// For each gap of the walk the vertex from which the arc between this gap and the next one of the walk starts.
    std::vector<std::size_t> corners;
    std::vector<UnannouncedArc> arcs;
    std::vector<int> overtaken_pairs;  ///< pairs that lie beyond the vertex: to be taken out, and the gluing done anew
    std::optional<std::string> failure;
};

/// Solves the vertex of `walk`. A walk of length k >= 4 whose geodesics do not all meet in one point is resolved into
/// branch points of lower degree with unannounced arcs between them.
VertexSolution solve_vertex(geodesic::GeodesicFlow& flow, const Gluing& gluing, std::span<const DirectionPair> pairs,
                            const Gluing::Walk& walk, std::optional<double> max_distance, double coincidence);

}  // namespace dsc::cutlocus
