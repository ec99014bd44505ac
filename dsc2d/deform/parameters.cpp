// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/deform/parameters.h"

#include <cmath>
#include <string>

#include "core/errors.h"

namespace dsc::dsc2d {

namespace {

void require(bool is_valid, const char* field, const char* range) {
    if (!is_valid) throw core::UsageError(std::string("2D deformation: ") + field + " must be " + range);
}

}  // namespace

void Parameters::validate() const {
    constexpr double pi = std::numbers::pi;
    require(edge_length > 0.0 && std::isfinite(edge_length), "edge_length", "positive");
    require(max_substeps >= 1, "max_substeps", "at least 1");
    require(approach > 0.0 && approach < 1.0, "approach", "in (0, 1)");
    require(interface_approach > 0.0 && interface_approach < 1.0, "interface_approach", "in (0, 1)");
    require(flips_on_the_way >= 0, "flips_on_the_way", "at least 0");
    require(contact_distance > 0.0 && contact_distance < 1.0, "contact_distance", "in (0, 1)");
    require(contact_fraction > 0.0 && contact_fraction < 1.0, "contact_fraction", "in (0, 1)");
    require(contact_minimum > 0.0 && contact_minimum <= contact_distance, "contact_minimum",
            "in (0, contact_distance]");
    require(contact_wedge > 0.0 && contact_wedge < pi, "contact_wedge", "in (0, pi)");
    require(blocked_substeps >= 1, "blocked_substeps", "at least 1");
    require(blocked_motion > 0.0, "blocked_motion", "positive");
    require(smoothing_sweeps >= 0, "smoothing_sweeps", "at least 0");
    require(degenerate_angle >= 0.0 && degenerate_angle < pi / 3, "degenerate_angle", "in [0, pi/3)");
    require(degenerate_area >= 0.0, "degenerate_area", "at least 0");
    require(steiner_min_edge >= 0.0, "steiner_min_edge", "at least 0");
    require(steiner_min_angle >= 0.0 && steiner_min_angle < pi / 3, "steiner_min_angle", "in [0, pi/3)");
    require(!poor_angle || (*poor_angle > 0.0 && *poor_angle < pi / 3), "poor_angle", "in (0, pi/3)");
    require(!needle_angle || (*needle_angle > 0.0 && *needle_angle < pi / 3), "needle_angle", "in (0, pi/3)");
    require(needle_min_length > 0.0, "needle_min_length", "positive");
    require(!interface_max_edge || *interface_max_edge > 0.0, "interface_max_edge", "positive");
    require(!interface_min_edge || *interface_min_edge > 0.0, "interface_min_edge", "positive");
    require(!interface_min_edge || !interface_max_edge || 2.0 * *interface_min_edge < *interface_max_edge,
            "interface_min_edge", "below half of interface_max_edge");
}

}  // namespace dsc::dsc2d
