// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of a flow: steps until the time is over, the observer asks for an end, no interface is left, or a step can't
// be made. Guarantee: the result says which of these it was, and ends with the last good state.
#pragma once

#include "apps/flow/result.h"
#include "core/errors.h"
#include "core/observer.h"
#include "core/stopwatch.h"

namespace dsc::flow {

/// What the loop does with a flow: take_step() adds a record to the result, or throws core::RunError or
/// core::Cancelled: then the last record is of the state as it is, if need be in the middle of a step; keep(record)
/// sees every record; is_empty(record) says that no interface is left; describe(record) is the text of the progress
/// line. Precondition: the result has the state at the start.
template <class Result, class Flow>
void run_steps(Result& result, Flow& flow, core::Observer& observer) {
    const core::Stopwatch whole;
    result.end = FlowEnd::done;
    result.reason = "done";
    while (result.steps.back().step < result.time.count) {
        try {
            observer.check_cancelled();
            flow.take_step();
        } catch (const core::Cancelled&) {
            result.end = FlowEnd::cancelled;
            result.reason = "stopped by the user";
            break;
        } catch (const core::RunError& error) {
            result.end = FlowEnd::stopped;
            result.reason = error.what();
            break;
        }
        const auto& record = result.steps.back();
        flow.keep(record);
        observer.progress("flowing", static_cast<double>(record.step) / result.time.count, flow.describe(record));
        if (flow.is_empty(record)) {
            result.end = FlowEnd::vanished;
            result.reason = "the interface has vanished";
            break;
        }
    }
    result.seconds += whole.seconds();
}

}  // namespace dsc::flow
