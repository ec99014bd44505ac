// SPDX-License-Identifier: GPL-3.0-or-later
// The built program cutlocus, run as a user would.
#pragma once

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "io/csv.h"
#include "io/json.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace dsc::tests {

using Arguments = std::vector<std::string>;

inline ProgramResult cutlocus_program(const Arguments& arguments) {
    return run_program(DSC_CUTLOCUS_PROGRAM, arguments);
}

/// The program fails with `exit_code`, nothing on stdout and one line on stderr that contains all of `words`.
inline void check_fails(const Arguments& arguments, int exit_code, const std::vector<std::string>& words = {}) {
    std::string line;
    for (const std::string& argument : arguments) line += argument + ' ';
    INFO("cutlocus " << line);
    const ProgramResult result = cutlocus_program(arguments);
    CHECK(result.exit_code == exit_code);
    CHECK(result.out.empty());
    INFO(result.err);
    CHECK(result.err_lines() == 1);
    CHECK(result.err.rfind("cutlocus: ", 0) == 0);
    for (const std::string& word : words) CHECK_THAT(result.err, Catch::Contains(word));
}

}  // namespace dsc::tests
