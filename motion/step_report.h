// SPDX-License-Identifier: GPL-3.0-or-later
// What one deformation step did and what it could not do. Source: thesis algorithm 4. Shared by 2D and 3D.
// Guarantee: motion that did not reach its target is listed here, never dropped.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/handles.h"

namespace dsc::motion {

/// Two places of the interface that were about to touch and were locked instead (thesis 5.2.2).
template <int Dimension>
struct Contact {
    core::VertexId a;
    core::VertexId b;
    Eigen::Matrix<double, Dimension, 1> place;  ///< halfway between a and b, in the cover coordinates of a
    Eigen::Matrix<int, Dimension, 1> lattice;   ///< position(b) + lattice translation lies next to position(a)
    double gap;                                 ///< distance of the two vertices when they were stopped
    int label;                                  ///< label of the region squeezed between them
};

template <int Dimension>
struct UnfinishedMotion {
    core::VertexId vertex;
    Eigen::Matrix<double, Dimension, 1> remaining;  ///< target minus position
    bool is_locked;                                 ///< stopped by a contact, not by a lack of substeps
};

struct StepCounts {
    std::size_t moves = 0;
    std::size_t blocked_moves = 0;
    std::size_t flips = 0;
    std::size_t collapses = 0;
    std::size_t edge_splits = 0;
    std::size_t face_splits = 0;
    std::size_t smoothings = 0;
    std::size_t topology_changes = 0;

    StepCounts& operator+=(const StepCounts& other) {
        moves += other.moves;
        blocked_moves += other.blocked_moves;
        flips += other.flips;
        collapses += other.collapses;
        edge_splits += other.edge_splits;
        face_splits += other.face_splits;
        smoothings += other.smoothings;
        topology_changes += other.topology_changes;
        return *this;
    }
};

template <int Dimension>
struct StepReport {
    bool is_complete = true;  ///< every vertex that is not locked reached its target
    int substeps = 0;
    std::vector<Contact<Dimension>> contacts;
    std::vector<UnfinishedMotion<Dimension>> unfinished;
    StepCounts counts;
};

}  // namespace dsc::motion
