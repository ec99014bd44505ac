// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/resumed_arguments.h"

#include <set>

#include "core/errors.h"

namespace dsc::apps {

namespace {

// Do not change the steps.
bool is_of_command(const std::string& option) {
    static const std::set<std::string> options = {"--output",  "--json",     "--quiet",
                                                  "--threads", "--progress", "--resume"};
    return options.contains(option);
}

}  // namespace

ResumedArguments::ResumedArguments(const std::string& program, const io::Json& at_start, const io::Json& now)
    : arguments_{program} {
    for (const auto& [option, value] : now.members()) {
        if (is_of_command(option)) continue;
        const std::string cure = "; leave it away, or start anew without --resume";
        if (!at_start.has(option)) throw core::UsageError(option + ": was not given when the run was started" + cure);
        if (at_start[option] == value) continue;
        throw core::UsageError(option + ": was " + at_start[option].string() + " when the run was started" + cure);
    }
    add(at_start, false);
    add(now, true);
    for (const std::string& argument : arguments_) pointers_.push_back(argument.c_str());
}

// As on a command line; `option=value`, since a value may begin with a dash.
void ResumedArguments::add(const io::Json& given, bool of_command) {
    for (const auto& [option, value] : given.members()) {
        if (is_of_command(option) != of_command || option == "--resume") continue;
        if (!value.is_string()) {
            arguments_.push_back(option);
        } else {
            arguments_.push_back(option.starts_with("-") ? option + "=" + value.string() : value.string());
        }
    }
}

}  // namespace dsc::apps
