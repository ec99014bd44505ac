// SPDX-License-Identifier: GPL-3.0-or-later
// Which states of a flow are kept. Guarantee: the first and the last one are among them; the rest is evenly spaced over
// the steps.
#pragma once

namespace dsc::flow {

/// True for `count` of the steps 0 .. steps, or all of them when there are fewer.
bool is_snapshot(int step, int steps, int count);

/// Asked once for each step, in ascending order.
class SnapshotTimes {
public:
    SnapshotTimes(int steps, int count) : steps_(steps), count_(count) {}

    /// Whether this state is kept.
    bool take(int step);
    /// ... when it is the last of a run, which may have ended early.
    bool take_last(int step);

private:
    int steps_, count_;
    int last_ = -1;
};

}  // namespace dsc::flow
