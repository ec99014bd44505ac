// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/snapshot_times.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace dsc::flow;

TEST_CASE("as many snapshots as asked for, the first and the last step among them") {
    for (const int steps : {1, 2, 7, 50, 360}) {
        for (const int count : {0, 2, 3, 20, 51, 1000}) {
            CAPTURE(steps, count);
            int found = 0, last = -1, widest = 0;
            for (int step = 0; step <= steps; ++step) {
                if (!is_snapshot(step, steps, count)) continue;
                if (last >= 0) widest = std::max(widest, step - last);
                last = step;
                ++found;
            }
            CHECK(found == std::min(count, steps + 1));
            if (count >= 2) {
                CHECK(is_snapshot(0, steps, count));
                CHECK(last == steps);
                CHECK(widest <= steps / std::min(count - 1, steps) + 1);
            }
        }
    }
}

TEST_CASE("the last state of a run that ends early is kept, once") {
    SnapshotTimes times(10, 3);
    CHECK(times.take(0));
    CHECK_FALSE(times.take(4));
    CHECK(times.take_last(4));
    CHECK_FALSE(times.take_last(4));
    SnapshotTimes none(10, 0);
    CHECK_FALSE(none.take(0));
    CHECK_FALSE(none.take_last(4));
}
