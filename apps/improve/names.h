// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line and the reports call things.
#pragma once

#include <array>

#include "apps/common/names.h"
#include "dsc3d/improve/improve.h"
#include "geometry/tetrahedron_quality.h"

namespace dsc::improve {

using apps::all_names;
using apps::Name;
using apps::name_of;
using apps::value_of;

inline constexpr std::array measure_names{
    Name{"sine", geometry::QualityMeasure::minimum_sine},
    Name{"biased-sine", geometry::QualityMeasure::minimum_biased_sine},
    Name{"volume-length", geometry::QualityMeasure::volume_length},
    Name{"radius-ratio", geometry::QualityMeasure::radius_ratio},
};

inline constexpr std::array schedule_names{
    Name{"thesis", dsc3d::Schedule::thesis},
    Name{"best", dsc3d::Schedule::best},
};

inline constexpr std::array end_names{
    Name{"converged", dsc3d::ImproveEnd::converged},
    Name{"target-angle", dsc3d::ImproveEnd::reached_target_angle},
    Name{"time-limit", dsc3d::ImproveEnd::reached_time_limit},
    Name{"cancelled", dsc3d::ImproveEnd::cancelled},
};

}  // namespace dsc::improve
