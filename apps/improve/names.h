// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line and the reports call things.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/assert.h"
#include "dsc3d/improve/improve.h"
#include "geometry/tetrahedron_quality.h"

namespace dsc::improve {

template <class Value>
struct Name {
    std::string_view name;
    Value value;
};

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

template <class Names>
std::vector<std::string> all_names(const Names& names) {
    std::vector<std::string> result;
    for (const auto& entry : names) result.emplace_back(entry.name);
    return result;
}

template <class Names, class Value>
std::string name_of(const Names& names, Value value) {
    for (const auto& entry : names) {
        if (entry.value == value) return std::string(entry.name);
    }
    DSC_ASSERT(false);
    return {};
}

/// Precondition: `name` is one of them.
template <class Names>
auto value_of(const Names& names, std::string_view name) {
    for (const auto& entry : names) {
        if (entry.name == name) return entry.value;
    }
    DSC_ASSERT(false);
    return names.front().value;
}

}  // namespace dsc::improve
