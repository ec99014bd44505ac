// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a run after some steps, as a user would.
#pragma once

#include "core/observer.h"

namespace dsc::tests {

class StopAfter final : public core::Observer {
public:
    explicit StopAfter(int steps) : left_(steps) {}
    void progress(std::string_view, double, std::string_view) override { --left_; }
    bool is_cancelled() const override { return left_ <= 0; }

private:
    int left_;
};

}  // namespace dsc::tests
