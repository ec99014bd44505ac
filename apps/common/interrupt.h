// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C and SIGTERM as a flag. The first one asks the computation to stop, a second one ends the process at once.
#pragma once

namespace dsc::apps {

/// Installs the signal handlers; called by run_main.
void catch_interrupts();

bool is_interrupted();

}  // namespace dsc::apps
