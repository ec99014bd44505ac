// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line calls the shapes and motions of the plane.
#pragma once

#include <array>

#include "apps/common/names.h"
#include "apps/flow/planar/options.h"

namespace dsc::flow::planar {

using apps::all_names;
using apps::Name;
using apps::name_of;

inline constexpr std::array shape_names{
    Name{"disc", Shape::disc},         Name{"two-discs", Shape::two_discs},           Name{"ring", Shape::ring},
    Name{"dumbbell", Shape::dumbbell}, Name{"slotted-disc", Shape::slotted_disc},     Name{"polygon", Shape::polygon},
    Name{"box", Shape::box},           Name{"labelled-block", Shape::labelled_block},
};

inline constexpr std::array motion_names{
    Name{"rotate", Motion::rotate},
    Name{"curvature", Motion::curvature},
    Name{"offset", Motion::offset},
    Name{"vortex", Motion::vortex},
    Name{"translate", Motion::translate},
    Name{"expression", Motion::expression},
    Name{"curl-noise", Motion::curl_noise},
    Name{"shear", Motion::shear},
    Name{"grid", Motion::grid},
};

}  // namespace dsc::flow::planar
