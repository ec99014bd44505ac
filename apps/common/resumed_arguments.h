// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of a run that goes on: what it was started with, and what is allowed to differ this time.
// Guarantee: options that change the steps are refused unless they are the same (core::UsageError).
#pragma once

#include <string>
#include <vector>

#include "io/json.h"

namespace dsc::apps {

class ResumedArguments {
public:
    /// `at_start` and `now`: CommandLine::given() of the two.
    ResumedArguments(const std::string& program, const io::Json& at_start, const io::Json& now);

    int argc() const { return static_cast<int>(pointers_.size()); }
    const char* const* argv() const { return pointers_.data(); }

private:
    void add(const io::Json& given, bool of_command);

    std::vector<std::string> arguments_;
    std::vector<const char*> pointers_;
};

}  // namespace dsc::apps
