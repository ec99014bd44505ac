// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the program fluid: what is asked for, checked.
#pragma once

#include <optional>
#include <string>

#include "apps/common/command_line.h"
#include "apps/fluid/run.h"
#include "apps/fluid/scene.h"

namespace dsc::fluid_app {

struct Options {
    Scene scene;
    RunParameters run;
    std::optional<double> stabilization, compensation, capillary_share;  ///< absent: the defaults of the library
    bool has_second_order_tension = false;
    bool conserves_momentum = true;
    int snapshots = 50;
    int checkpoint_interval = 25;  ///< steps; 0: no checkpoints
    bool is_resumed = false;
    std::string folder;
    apps::CommonOptions common;
    io::Json given;  ///< the options on the command line, for the report
};

/// Nothing when --help or --version was asked for. With --resume, what the run was started with is taken from the
/// checkpoint in its folder. Throws core::UsageError and core::InputError.
std::optional<Options> parse_options(int argc, const char* const* argv);

}  // namespace dsc::fluid_app
