// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/resume.h"

#include <set>
#include <string>
#include <vector>

#include "core/assert.h"
#include "core/errors.h"

namespace dsc::flow {

namespace {

// Do not change the steps.
bool is_of_command(const std::string& option) {
    static const std::set<std::string> options = {"--output",  "--json",     "--quiet",
                                                  "--threads", "--progress", "--resume"};
    return options.contains(option);
}

void require_same(const io::Json& at_start, const io::Json& now) {
    for (const auto& [option, value] : now.members()) {
        if (is_of_command(option)) continue;
        const std::string cure = "; leave it away, or start anew without --resume";
        if (!at_start.has(option)) throw core::UsageError(option + ": was not given when the run was started" + cure);
        if (at_start[option] == value) continue;
        throw core::UsageError(option + ": was " + at_start[option].string() + " when the run was started" + cure);
    }
}

// As on a command line; `option=value`, since a value may begin with a dash.
void add_arguments(const io::Json& given, bool of_command, std::vector<std::string>& arguments) {
    for (const auto& [option, value] : given.members()) {
        if (is_of_command(option) != of_command || option == "--resume") continue;
        if (!value.is_string()) {
            arguments.push_back(option);
        } else {
            arguments.push_back(option.starts_with("-") ? option + "=" + value.string() : value.string());
        }
    }
}

}  // namespace

Options options_of(const SavedRun& run, const Options& resuming) {
    require_same(run.options, resuming.given);
    std::vector<std::string> arguments = {"flow"};
    add_arguments(run.options, false, arguments);
    add_arguments(resuming.given, true, arguments);
    std::vector<const char*> argv;
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    std::optional<Options> options = parse_options(static_cast<int>(argv.size()), argv.data());
    DSC_ASSERT(options);
    options->given = run.options;
    options->is_resumed = true;
    return *options;
}

}  // namespace dsc::flow
