// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

namespace dsc::core {

namespace {

// Keeps the exception of the lowest piece. Pieces above a failed one are skipped; those below must still run, since one
// of them may fail too and would then be the one to report.
class FirstFailure {
public:
    bool is_above(std::size_t begin) const { return begin > lowest_.load(std::memory_order_relaxed); }

    void note(std::size_t begin) {
        const std::scoped_lock lock(mutex_);
        if (begin >= lowest_.load(std::memory_order_relaxed)) return;
        lowest_.store(begin, std::memory_order_relaxed);
        failure_ = std::current_exception();
    }

    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    std::atomic<std::size_t> lowest_{static_cast<std::size_t>(-1)};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace

int available_threads() { return std::max(1, tbb::info::default_concurrency()); }

void detail::parallel_pieces(std::size_t count, const ParallelParameters& parameters,
                             void (*body)(void* context, std::size_t begin, std::size_t end), void* context) {
    const std::size_t grain = std::max<std::size_t>(parameters.grain, 1);
    // TBB prints a warning when it is asked for more threads than there are.
    const int threads =
        parameters.threads > 0 ? std::min(parameters.threads, available_threads()) : available_threads();
    if (threads == 1 || count <= grain) {
        if (count > 0) body(context, 0, count);
        return;
    }
    const std::size_t pieces = (count + grain - 1) / grain;
    FirstFailure failure;
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, pieces, [&](std::size_t piece) {
            const std::size_t begin = piece * grain;
            if (failure.is_above(begin)) return;
            try {
                body(context, begin, std::min(begin + grain, count));
            } catch (...) {
                failure.note(begin);
            }
        });
    });
    failure.rethrow();
}

}  // namespace dsc::core
