// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_length.h"

#include "surface/parameter_check.h"

namespace dsc::surface {

void EdgeLengthParameters::validate() const {
    require_range(split_above > 0, "split_above", "positive");
    require_range(collapse_below >= 0 && collapse_below <= split_above / 2, "collapse_below",
                  "in [0, split_above / 2]");
}

}  // namespace dsc::surface
