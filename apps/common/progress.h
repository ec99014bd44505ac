// SPDX-License-Identifier: GPL-3.0-or-later
// The observer of a program: one line of progress on stderr, and cancellation by Ctrl-C.
// Guarantee: nothing is printed with --quiet, nor by `automatic` when stderr is no terminal; the line is rewritten at
// most ten times a second and cleared at the end.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

#include "core/observer.h"

namespace dsc::apps {

enum class ProgressMode { automatic, none, bar };

class ProgressObserver final : public core::Observer {
public:
    explicit ProgressObserver(ProgressMode mode, std::FILE* stream = stderr);
    ~ProgressObserver() override;
    ProgressObserver(const ProgressObserver&) = delete;
    ProgressObserver& operator=(const ProgressObserver&) = delete;

    void progress(std::string_view stage, double fraction, std::string_view figure) override;
    bool is_cancelled() const override;
    /// Removes the line; the next progress shows it again. To be called before printing something else.
    void clear();

private:
    std::FILE* stream_;
    bool is_shown_;
    std::size_t width_;
    bool is_line_ = false;
    std::chrono::steady_clock::time_point last_;
};

}  // namespace dsc::apps
