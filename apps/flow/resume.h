// SPDX-License-Identifier: GPL-3.0-or-later
// From --resume to the options of the run that goes on: they are those of its checkpoint.
#pragma once

#include "apps/flow/checkpoint.h"
#include "apps/flow/options.h"

namespace dsc::flow {

/// The options the run was started with, but for where its results go and what is printed meanwhile: those are of the
/// command that resumes. Throws core::UsageError when anything else on that command line is not as at the start.
Options options_of(const SavedRun& run, const Options& resuming);

}  // namespace dsc::flow
