// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the program reconstruct: what is asked for, checked.
#pragma once

#include <optional>
#include <string>

#include "apps/common/command_line.h"
#include "apps/reconstruct/reconstruct.h"

namespace dsc::reconstruct {

struct Options {
    std::string input;
    ReconstructParameters parameters;
    std::optional<std::string> tets, html, snapshots;
    apps::CommonOptions common;
    io::Json given;
};

/// Nothing when --help or --version was asked for. Throws core::UsageError and core::InputError.
std::optional<Options> parse_options(int argc, const char* const* argv);

}  // namespace dsc::reconstruct
