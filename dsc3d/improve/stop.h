// SPDX-License-Identifier: GPL-3.0-or-later
// When an improvement ends before it has converged: cancelled, or out of time. Cost: a read of the clock per question.
#pragma once

#include <chrono>
#include <optional>

#include "core/observer.h"

namespace dsc::dsc3d {

class StopCondition {
public:
    /// The time runs from construction.
    StopCondition(const core::Observer& observer, std::optional<double> time_limit)
        : observer_(observer), time_limit_(time_limit), start_(std::chrono::steady_clock::now()) {}

    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    bool is_cancelled() const { return observer_.is_cancelled(); }
    bool is_out_of_time() const { return time_limit_ && seconds() >= *time_limit_; }
    bool is_due() const { return is_cancelled() || is_out_of_time(); }

private:
    const core::Observer& observer_;
    std::optional<double> time_limit_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace dsc::dsc3d
