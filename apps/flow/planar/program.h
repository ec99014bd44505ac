// SPDX-License-Identifier: GPL-3.0-or-later
// The program flow with --dimension 2, from the options to the files.
#pragma once

#include "apps/flow/options.h"

namespace dsc::flow::planar {

/// The exit code. Throws core::UsageError, core::InputError and, after writing the last good state, core::RunError.
/// Precondition: options.planar.
int run(const flow::Options& options);

}  // namespace dsc::flow::planar
