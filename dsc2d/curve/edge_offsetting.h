// SPDX-License-Identifier: GPL-3.0-or-later
// Motion in the normal direction that keeps corners: the lines of the segments at a vertex are offset, and the vertex
// goes to where they meet.
// Source: thesis 4.4.1.3; Jiao (2007), "Face offsetting: a unified approach for explicit moving interfaces", in the
// plane. Least squares over the lines within the primary space of the quadric; the part in the null space is zero.
// Guarantee: where two segments meet, the vertex goes to the meeting of their lines (to rounding), up to the longest
// step. Cost: linear.
#pragma once

#include <vector>

#include "dsc2d/interface.h"

namespace dsc::dsc2d {

struct OffsetParameters {
    /// Lines whose normals are further apart are kept apart [degree]. In (0, 90).
    double feature_angle = 1;
    /// Longest step of a vertex: the tip of a needle would run away [distance]. >= 1.
    double max_stretch = 5;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// One for each vertex of the interface, when every segment moves by `distance` to its right: out of objects, into the
/// background.
std::vector<Point2> offset_displacements(const Interface& interface, double distance,
                                         const OffsetParameters& parameters);

}  // namespace dsc::dsc2d
