// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/parameters.h"

#include <cmath>
#include <string>

#include "core/errors.h"

namespace dsc::dsc3d {

void DeformParameters::validate() const {
    const auto require = [](bool condition, const char* field, const char* range) {
        if (!condition) throw core::UsageError(std::string(field) + ": has to be " + range);
    };
    require(edge_length > 0 && std::isfinite(edge_length), "edge_length", "positive");
    require(growth >= 0, "growth", "at least 0");
    require(contact_distance > 0, "contact_distance", "positive");
    require(contact_cosine > -1 && contact_cosine < 0, "contact_cosine", "in (-1, 0)");
    require(wall_cosine > -1 && wall_cosine < 0, "wall_cosine", "in (-1, 0)");
    require(waist_share > 0 && waist_share <= 1, "waist_share", "in (0, 1]");
    require(gap_width >= contact_distance, "gap_width", "at least contact_distance");
    require(gap_reach >= 0, "gap_reach", "at least 0");
    require(foot_width > 0, "foot_width", "positive");
    require(crumb_volume >= 0, "crumb_volume", "at least 0");
    require(thread_volume >= 0, "thread_volume", "at least 0");
    require(stride > 0, "stride", "positive");
    require(most_line_substeps >= 1, "most_line_substeps", "at least 1");
    require(most_substeps >= 1, "most_substeps", "at least 1");
    require(max_substeps >= 1, "max_substeps", "at least 1");
    require(max_stalls >= 1, "max_stalls", "at least 1");
    require(stalling_share > 0 && stalling_share <= 1, "stalling_share", "in (0, 1]");
    require(approach > 0 && approach < 1, "approach", "in (0, 1)");
    require(carried_rings >= 0, "carried_rings", "at least 0");
    require(poor_quality > 0 && poor_quality < 1, "poor_quality", "in (0, 1)");
    require(bad_quality >= 0 && bad_quality <= poor_quality, "bad_quality", "in [0, poor_quality]");
    require(stopping_quality > 0 && stopping_quality < poor_quality, "stopping_quality", "in (0, poor_quality)");
    require(upkeep_rounds >= 1, "upkeep_rounds", "at least 1");
    require(escape_attempts >= 0, "escape_attempts", "at least 0");
    require(least_escapes >= 0, "least_escapes", "at least 0");
    require(escape_share >= 0, "escape_share", "at least 0");
    require(insertion_edge >= 0, "insertion_edge", "at least 0");
    require(insertion_gain >= 1, "insertion_gain", "at least 1");
    require(max_edge > 0, "max_edge", "positive");
    require(min_edge >= 0 && min_edge <= max_edge / 2, "min_edge", "in [0, max_edge / 2]");
    require(collapse_quality > 0 && collapse_quality < 1, "collapse_quality", "in (0, 1)");
    require(interface_quality > 0 && interface_quality < 1, "interface_quality", "in (0, 1)");
    require(degenerate_edge >= 0 && degenerate_edge < 0.5, "degenerate_edge", "in [0, 0.5)");
    require(degenerate_height >= 0 && degenerate_height < 0.5, "degenerate_height", "in [0, 0.5)");
    interface_lengths.validate();
    contact_line_lengths.validate();
    interface_split.validate();
    interface_collapse.validate();
    interface_flip.validate();
    interface_smoothing.validate();
}

}  // namespace dsc::dsc3d
