// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of a surface are too long or too short, by the lengths wanted at their ends.
// Source: thesis 4.3.2.2. Guarantee: neither half of an edge that is too long is too short. Cost: constant.
#pragma once

namespace dsc::surface {

struct EdgeLengthParameters {
    /// Longer edges are split [wanted length]. > 0.
    double split_above = 1.3;
    /// Shorter edges are collapsed [wanted length]. In [0, split_above / 2].
    double collapse_below = 0.45;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// The length of an edge over the mean of the lengths wanted at its ends.
inline double relative_length(double length, double wanted_a, double wanted_b) {
    return 2 * length / (wanted_a + wanted_b);
}

inline bool is_too_long(double relative_length, const EdgeLengthParameters& parameters) {
    return relative_length > parameters.split_above;
}
inline bool is_too_short(double relative_length, const EdgeLengthParameters& parameters) {
    return relative_length < parameters.collapse_below;
}

}  // namespace dsc::surface
