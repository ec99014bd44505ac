// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program as a user would, to test exit codes, files and messages.
//
//     const tests::ProgramResult result = tests::run_program(DSC_CUTLOCUS, {"--lambda", "-1"});
//     CHECK(result.exit_code == 2);
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace dsc::tests {

struct ProgramResult {
    int exit_code = -1;  ///< 128 + signal when a signal ended it
    std::string out;
    std::string err;

    /// Number of lines on stderr.
    int err_lines() const;
};

/// When `interrupt_at` is not empty, SIGINT is sent once that text has appeared on stdout.
ProgramResult run_program(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& interrupt_at = {});

/// The exit code of the program when it is killed (SIGKILL) once `is_time`, which is asked every millisecond, unless it
/// has ended by then.
int run_program_killed(const std::string& program, const std::vector<std::string>& arguments,
                       const std::function<bool()>& is_time);

}  // namespace dsc::tests
