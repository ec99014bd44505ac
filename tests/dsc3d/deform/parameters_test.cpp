// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/parameters.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

using namespace dsc::dsc3d;

TEST_CASE("deformation parameters out of their range are refused by name, and only the edge length has no default") {
    CHECK_THROWS_WITH(DeformParameters{}.validate(), Catch::StartsWith("edge_length"));
    CHECK_NOTHROW(DeformParameters{.edge_length = 1e-9}.validate());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto refused = [](const char* name, const std::function<void(DeformParameters&)>& spoil) {
        DeformParameters parameters = {.edge_length = 1};
        spoil(parameters);
        CHECK_THROWS_WITH(parameters.validate(), Catch::StartsWith(name));
    };
    using P = DeformParameters;
    refused("edge_length", [](P& p) { p.edge_length = infinity; });
    refused("edge_length", [](P& p) { p.edge_length = std::nan(""); });
    refused("growth", [](P& p) { p.growth = -0.1; });
    refused("contact_distance", [](P& p) { p.contact_distance = 0; });
    refused("contact_cosine", [](P& p) { p.contact_cosine = 0; });
    refused("contact_cosine", [](P& p) { p.contact_cosine = -1; });
    refused("gap_width", [](P& p) { p.gap_width = 0.9 * p.contact_distance; });
    refused("gap_reach", [](P& p) { p.gap_reach = -1; });
    refused("crumb_volume", [](P& p) { p.crumb_volume = -1; });
    refused("thread_volume", [](P& p) { p.thread_volume = -1; });
    refused("stride", [](P& p) { p.stride = 0; });
    refused("max_substeps", [](P& p) { p.max_substeps = 0; });
    refused("stalling_share", [](P& p) { p.stalling_share = 1.1; });
    refused("approach", [](P& p) { p.approach = 1; });
    refused("stopping_quality", [](P& p) { p.stopping_quality = p.poor_quality; });
    refused("carried_rings", [](P& p) { p.carried_rings = -1; });
    refused("poor_quality", [](P& p) { p.poor_quality = 1; });
    refused("bad_quality", [](P& p) { p.bad_quality = 1.1 * p.poor_quality; });
    refused("upkeep_rounds", [](P& p) { p.upkeep_rounds = 0; });
    refused("escape_attempts", [](P& p) { p.escape_attempts = -1; });
    refused("insertion_edge", [](P& p) { p.insertion_edge = -1; });
    refused("insertion_gain", [](P& p) { p.insertion_gain = 0.9; });
    refused("max_edge", [](P& p) { p.max_edge = 0; });
    refused("min_edge", [](P& p) { p.min_edge = 0.6 * p.max_edge; });
    refused("collapse_quality", [](P& p) { p.collapse_quality = 0; });
    refused("interface_quality", [](P& p) { p.interface_quality = 1; });
    refused("degenerate_edge", [](P& p) { p.degenerate_edge = 0.5; });
    refused("degenerate_height", [](P& p) { p.degenerate_height = -1; });
    refused("split_above", [](P& p) { p.interface_lengths.split_above = 0; });
    refused("max_turn", [](P& p) { p.interface_collapse.max_turn = 90; });
    refused("min_gain", [](P& p) { p.interface_flip.min_gain = -1; });
}
