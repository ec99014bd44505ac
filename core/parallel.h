// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops over an index range: "evaluate in parallel, change in canonical order".
// Guarantee: every index is visited exactly once; when each index writes only its own slot the result has the same bits
// for any number of threads. The exception that leaves the loop is the one of the lowest index that threw.
// Cost: one indirect call per `grain` indices; with one thread a plain loop.
//
//     std::vector<double> quality(mesh.size());
//     core::parallel_for(quality.size(), {.threads = 2}, [&](std::size_t i) { quality[i] = measure(mesh, i); });
#pragma once

#include <cstddef>
#include <type_traits>

namespace dsc::core {

struct ParallelParameters {
    int threads = 0;         ///< threads to use at most; 0: as many as the machine has
    std::size_t grain = 64;  ///< indices per piece of work
};

/// The number of threads that `threads = 0` stands for.
int available_threads();

namespace detail {
/// Calls body(context, begin, end) for all pieces of {0, …, count - 1}, concurrently.
void parallel_pieces(std::size_t count, const ParallelParameters& parameters,
                     void (*body)(void* context, std::size_t begin, std::size_t end), void* context);
}  // namespace detail

/// Calls function(i) for every i in {0, …, count - 1}, in any order, at the same time where there are threads.
template <class Function>
void parallel_for(std::size_t count, const ParallelParameters& parameters, Function&& function) {
    using Stored = std::remove_reference_t<Function>;
    const auto body = [](void* context, std::size_t begin, std::size_t end) {
        for (Stored& call = *static_cast<Stored*>(context); begin != end; ++begin) call(begin);
    };
    detail::parallel_pieces(count, parameters, body,
                            const_cast<void*>(static_cast<const void*>(&function)));  // a const lambda stays const
}

template <class Function>
void parallel_for(std::size_t count, Function&& function) {
    parallel_for(count, ParallelParameters{}, function);
}

}  // namespace dsc::core
