// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line and the report call things.
#pragma once

#include <array>

#include "apps/common/names.h"
#include "apps/flow/options.h"

namespace dsc::flow {

using apps::all_names;
using apps::Name;
using apps::name_of;
using apps::value_of;

inline constexpr std::array shape_names{
    Name{"sphere", Shape::sphere},
    Name{"box", Shape::box},
    Name{"torus", Shape::torus},
    Name{"dumbbell", Shape::dumbbell},
    Name{"two-spheres", Shape::two_spheres},
    Name{"slotted-cube", Shape::slotted_cube},
    Name{"labelled-block", Shape::labelled_block},
};

inline constexpr std::array motion_names{
    Name{"rotate", Motion::rotate},         Name{"curvature", Motion::curvature},
    Name{"offset", Motion::offset},         Name{"enright", Motion::enright},
    Name{"vortex", Motion::vortex},         Name{"translate", Motion::translate},
    Name{"expression", Motion::expression}, Name{"curl-noise", Motion::curl_noise},
    Name{"shear", Motion::shear},           Name{"grid", Motion::grid},
};

inline constexpr std::array topology_names{
    Name{"adaptive", motion::TopologyPolicy::adaptive},
    Name{"preserved", motion::TopologyPolicy::preserved},
    Name{"merge-only", motion::TopologyPolicy::merge_only},
    Name{"split-only", motion::TopologyPolicy::split_only},
};

}  // namespace dsc::flow
