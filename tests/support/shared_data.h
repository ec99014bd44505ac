// SPDX-License-Identifier: GPL-3.0-or-later
// The shared folder of reference data (cut loci, meshes, point clouds), which is not part of the repository:
// $DSC_SHARED_DATA, or ../shared/data beside the repository. Tests that need it carry the tag [shared], skip when it is
// absent, and say so ("SKIPPED: …"; ctest then counts them as skipped, not as passed).
//
//     TEST_CASE("agrees with the references", "[shared]") {
//         DSC_NEEDS_SHARED_DATA("cutlocus");
//         const std::filesystem::path file = tests::shared_data("cutlocus/circ_p0000.csv");
#pragma once

#include <filesystem>
#include <iostream>
#include <string>

namespace dsc::tests {

/// The place of `name` in the shared data, whether or not it exists.
std::filesystem::path shared_data(const std::string& name);

/// The root of the repository the tests were built from.
std::filesystem::path source_folder();

}  // namespace dsc::tests

/// Leaves the test case, saying so, when `name` is not among the shared data.
#define DSC_NEEDS_SHARED_DATA(name)                                              \
    do {                                                                         \
        if (!std::filesystem::exists(::dsc::tests::shared_data(name))) {         \
            std::cout << "SKIPPED: " << ::dsc::tests::shared_data(name).string() \
                      << " is absent; set DSC_SHARED_DATA\n";                    \
            return;                                                              \
        }                                                                        \
    } while (false)
