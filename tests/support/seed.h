// SPDX-License-Identifier: GPL-3.0-or-later
// Seeds of random inputs. A failing test prints the seeds it used; the environment variable DSC_TEST_SEED replaces
// every seed, to have a failure again or to try other inputs.
//
//     core::Random random(tests::seed(1));
#pragma once

#include <cstdint>
#include <vector>

namespace dsc::tests {

/// `default_seed`, or the value of DSC_TEST_SEED; noted for the report of a failure.
std::uint64_t seed(std::uint64_t default_seed);

/// The seeds handed out in the running test case, in order.
const std::vector<std::uint64_t>& seeds_used();
void forget_seeds();

}  // namespace dsc::tests
