// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_length.h"

#include "core/require.h"

namespace dsc::surface {

void EdgeLengthParameters::validate() const {
    core::require(split_above > 0, "split_above", "positive");
    core::require(collapse_below >= 0 && collapse_below <= split_above / 2, "collapse_below",
                  "in [0, split_above / 2]");
}

}  // namespace dsc::surface
