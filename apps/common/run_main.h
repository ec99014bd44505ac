// SPDX-License-Identifier: GPL-3.0-or-later
// What every main() does: run the program, turn exceptions into one line on stderr and an exit code.
// Guarantee: 0 done, 1 ran but failed or was stopped, 2 usage or bad input; Ctrl-C ends at the next point where the
// computation looks at its observer; output that stdout did not take counts as failed.
//
//     int main(int argc, char** argv) {
//         return dsc::apps::run_main("cutlocus", [&] {
//             Options options;
//             if (!parse(argc, argv, options)) return 0;
//             return run(options);
//         });
//     }
#pragma once

#include <functional>
#include <string>

namespace dsc::apps {

enum ExitCode : int { exit_done = 0, exit_failed = 1, exit_usage = 2 };

/// Runs `program`, which returns an exit code; `name` begins the line on stderr.
int run_main(const std::string& name, const std::function<int()>& program);

}  // namespace dsc::apps
