// SPDX-License-Identifier: GPL-3.0-or-later
// The program flow with --dimension 2, from the options to the files.
#pragma once

#include "apps/common/checkpoint_file.h"
#include "apps/flow/options.h"

namespace dsc::flow::planar {

// The exit codes. Throw core::UsageError, core::InputError and, after writing the last good state, core::RunError.
// Precondition: options.planar.

int start(const flow::Options& options);
/// Goes on from a checkpoint; the options are those of its run.
int resume(const flow::Options& options, apps::CheckpointFile& file);

}  // namespace dsc::flow::planar
