// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/time_steps.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/errors.h"

namespace dsc::flow {

namespace {

constexpr int default_steps = 50;
constexpr double most_steps = 1e7;

double default_end(const MotionOptions& motion) {
    return motion.motion == Motion::enright || motion.motion == Motion::vortex ? motion.period : 1;
}

// The path of a step is followed by its chords, which don't see whole turns.
void require_visible_turns(const MotionOptions& motion, const TimeSteps& time) {
    if (motion.motion != Motion::rotate) return;
    const double turn = std::abs(motion.angle) * time.dt / time.until;
    if (turn > 360)
        throw core::UsageError(
            fmt::format("--angle: {:g} degrees in a step are more than a full turn; take more steps", turn));
}

}  // namespace

TimeSteps time_steps(const TimeOptions& options, const MotionOptions& motion) {
    DSC_ASSERT(!(options.dt && options.until && options.steps));
    TimeSteps result;
    if (options.dt && options.steps) {
        if (!std::isfinite(*options.dt * *options.steps))
            throw core::UsageError("--dt: times --steps is beyond all numbers");
        result = {.dt = *options.dt, .until = *options.dt * *options.steps, .count = *options.steps};
    } else {
        result.until = options.until.value_or(default_end(motion));
        if (options.dt) {
            result.dt = std::min(*options.dt, result.until);
            // A remainder below rounding is no step of its own.
            const double count = std::ceil(result.until / result.dt * (1 - 1e-12));
            if (count > most_steps) throw core::UsageError("--dt: that would be more than 10000000 steps");
            result.count = static_cast<int>(count);
        } else {
            result.count = options.steps.value_or(default_steps);
            result.dt = result.until / result.count;
        }
    }
    if (result.count > most_steps) throw core::UsageError("--steps: has to be at most 10000000");
    require_visible_turns(motion, result);
    return result;
}

}  // namespace dsc::flow
