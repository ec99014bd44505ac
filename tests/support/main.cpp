// SPDX-License-Identifier: GPL-3.0-or-later
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

#include <cstdlib>
#include <iostream>

#include "tests/support/seed.h"

namespace {

// Says which random inputs a failing test ran on, so that the failure can be had again.
class SeedReport final : public Catch::TestEventListenerBase {
public:
    using TestEventListenerBase::TestEventListenerBase;

    void testCaseStarting(const Catch::TestCaseInfo&) override { dsc::tests::forget_seeds(); }
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        if (stats.totals.assertions.allOk() || dsc::tests::seeds_used().empty()) return;
        std::cerr << "seeds used by \"" << stats.testInfo.name << "\":";
        for (const std::uint64_t seed : dsc::tests::seeds_used()) std::cerr << ' ' << seed;
        std::cerr << "; again with DSC_TEST_SEED=" << dsc::tests::seeds_used().back() << '\n';
    }
};

CATCH_REGISTER_LISTENER(SeedReport)

std::vector<std::uint64_t> seeds;

}  // namespace

namespace dsc::tests {

void forget_seeds() { seeds.clear(); }
const std::vector<std::uint64_t>& seeds_used() { return seeds; }

std::uint64_t seed(std::uint64_t default_seed) {
    const char* wish = std::getenv("DSC_TEST_SEED");
    const std::uint64_t value = wish != nullptr ? std::strtoull(wish, nullptr, 10) : default_seed;
    seeds.push_back(value);
    return value;
}

}  // namespace dsc::tests
