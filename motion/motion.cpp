// SPDX-License-Identifier: GPL-3.0-or-later
// Headers without a source of their own are checked here for being self-contained.
#include "motion/cfl.h"
#include "motion/grid_field.h"
#include "motion/rigid.h"
#include "motion/runge_kutta.h"
#include "motion/step_report.h"
#include "motion/topology.h"
#include "motion/velocity.h"
