// SPDX-License-Identifier: GPL-3.0-or-later
// What command lines and reports call the values of an enumeration.
//
//     inline constexpr std::array end_names{apps::Name{"done", End::done}, apps::Name{"cancelled", End::cancelled}};
//     report["end"] = apps::name_of(end_names, End::done);
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/assert.h"

namespace dsc::apps {

template <class Value>
struct Name {
    std::string_view name;
    Value value;
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

}  // namespace dsc::apps
