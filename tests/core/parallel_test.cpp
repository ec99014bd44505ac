// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using dsc::core::parallel_for;

TEST_CASE("a parallel loop visits every index once") {
    for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 10007u}) {
        for (const int threads : {0, 1, 2, 7}) {
            std::vector<std::atomic<int>> visits(count);
            parallel_for(count, {.threads = threads, .grain = 16}, [&](std::size_t i) { ++visits[i]; });
            for (const auto& v : visits) REQUIRE(v == 1);
        }
    }
}

TEST_CASE("a parallel loop gives the same bits on any number of threads") {
    const auto evaluate = [](int threads) {
        std::vector<double> values(20000);
        parallel_for(values.size(), {.threads = threads}, [&](std::size_t i) {
            const double x = static_cast<double>(i);
            values[i] = std::sin(x) * std::exp(1e-4 * x);
        });
        return values;
    };
    const std::vector<double> serial = evaluate(1);
    CHECK(evaluate(2) == serial);
    CHECK(evaluate(5) == serial);
}

TEST_CASE("the exception of a parallel loop is that of the lowest index") {
    for (const int threads : {1, 2, 4}) {
        for (int repetition = 0; repetition < 20; ++repetition) {
            std::string message;
            try {
                parallel_for(5000, {.threads = threads, .grain = 8}, [](std::size_t i) {
                    if (i == 4711 || i == 4999 || i == 700) throw std::runtime_error(std::to_string(i));
                });
            } catch (const std::runtime_error& error) {
                message = error.what();
            }
            REQUIRE(message == "700");
        }
    }
}

TEST_CASE("at least one thread is available") { CHECK(dsc::core::available_threads() >= 1); }
