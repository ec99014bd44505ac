// SPDX-License-Identifier: GPL-3.0-or-later
// Both headers are checked here for being self-contained.
#include "motion/step_report.h"
#include "motion/topology.h"
