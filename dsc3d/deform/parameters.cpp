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
    require(max_substeps >= 1, "max_substeps", "at least 1");
    require(approach > 0 && approach < 1, "approach", "in (0, 1)");
    require(poor_quality > 0 && poor_quality < 1, "poor_quality", "in (0, 1)");
    require(stopping_quality > 0 && stopping_quality < poor_quality, "stopping_quality", "in (0, poor_quality)");
    require(degenerate_quality >= 0 && degenerate_quality < poor_quality, "degenerate_quality", "in [0, poor_quality)");
    require(min_edge >= 0, "min_edge", "at least 0");
    require(collapse_quality > 0 && collapse_quality < 1, "collapse_quality", "in (0, 1)");
    require(max_bridge > 0, "max_bridge", "positive");
}

}  // namespace dsc::dsc3d
