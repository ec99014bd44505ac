// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/passes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

#include "core/errors.h"

namespace dsc::flow {

namespace {

using dsc3d::DeformParameters;

struct Pass {
    const char* name;
    void (*switch_off)(DeformParameters&);
};

constexpr std::array passes{
    Pass{"carrying", [](DeformParameters& p) { p.carried_rings = 0; }},
    Pass{"smoothing", [](DeformParameters& p) { p.smooths = false; }},
    Pass{"flips", [](DeformParameters& p) { p.flips = false; }},
    Pass{"thinning", [](DeformParameters& p) { p.thins = false; }},
    Pass{"escapes",
         [](DeformParameters& p) {
             p.least_escapes = 0;
             p.escape_share = 0;
         }},
    Pass{"insertion", [](DeformParameters& p) { p.insertion_edge = std::numeric_limits<double>::max(); }},
    Pass{"detail", [](DeformParameters& p) { p.controls_detail = false; }},
    Pass{"interface-collapses", [](DeformParameters& p) { p.collapses_interface = false; }},
    Pass{"interface-splits", [](DeformParameters& p) { p.splits_interface = false; }},
    Pass{"interface-flips", [](DeformParameters& p) { p.flips_interface = false; }},
    Pass{"interface-smoothing", [](DeformParameters& p) { p.smooths_interface = false; }},
};

}  // namespace

std::vector<std::string> pass_names() {
    std::vector<std::string> names;
    for (const Pass& pass : passes) names.emplace_back(pass.name);
    return names;
}

void switch_off(const std::string& list, DeformParameters& parameters) {
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        const auto* pass = std::ranges::find_if(passes, [&](const Pass& entry) { return entry.name == word; });
        if (pass == passes.end()) {
            std::string names;
            for (const std::string& name : pass_names()) names += (names.empty() ? "" : ", ") + name;
            throw core::UsageError("--without: \"" + word + "\" is no pass; there are " + names);
        }
        pass->switch_off(parameters);
    }
}

}  // namespace dsc::flow
