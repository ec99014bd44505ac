// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observer.h"

#include <catch2/catch.hpp>

using namespace dsc::core;

namespace {
struct Impatient final : Observer {
    bool is_cancelled() const override { return true; }
};
}  // namespace

TEST_CASE("the default observer lets everything run; a cancelled one ends it by an exception") {
    Observer quiet;
    quiet.progress("stage", 0.5, "figure");
    CHECK_NOTHROW(quiet.check_cancelled());
    CHECK_THROWS_AS(Impatient().check_cancelled(), Cancelled);
}
