// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/interrupt.h"

#include <atomic>
#include <csignal>

namespace dsc::apps {

namespace {

// Lock-free, so that a signal handler may set it and other threads may read it.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void on_signal(int) { interrupted.store(true, std::memory_order_relaxed); }

}  // namespace

void catch_interrupts() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    // SA_RESETHAND: the second signal finds the default action, which ends the process.
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    // A file beyond the limit of the user is an error of writing, to be reported like a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
}

bool is_interrupted() { return interrupted.load(std::memory_order_relaxed); }

}  // namespace dsc::apps
