// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the program improve: what is asked for, checked.
#pragma once

#include <optional>
#include <string>

#include "apps/common/command_line.h"
#include "dsc3d/improve/improve.h"

namespace dsc::improve {

struct Options {
    std::string input;
    dsc3d::ImproveParameters parameters;
    bool is_report_only = false;
    bool merges_regions = false;
    std::optional<std::string> svg, html;
    apps::CommonOptions common;

    /// True when the mesh or figures go to a file.
    bool has_output() const { return common.output || common.json || svg || html; }
};

/// Nothing when --help or --version was asked for. Throws core::UsageError and core::InputError.
std::optional<Options> parse_options(int argc, const char* const* argv);

}  // namespace dsc::improve
