// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pool.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <thread>

using namespace dsc::core;

TEST_CASE("one thread is served by one object, also after a call that failed") {
    int made = 0;
    Pool<int> pool([&] { return std::make_unique<int>(++made); });
    CHECK(pool.use([](int& object) { return object; }) == 1);
    CHECK_THROWS_AS(pool.use([](int&) { throw std::runtime_error("failed"); }), std::runtime_error);
    CHECK(pool.use([](int& object) { return object; }) == 1);
    CHECK(made == 1);
    CHECK(pool.use([&](int& outer) { return pool.use([&](int& inner) { return 10 * outer + inner; }); }) == 12);
}

TEST_CASE("no object serves two threads at a time, and there are no more than threads") {
    std::atomic<int> made = 0;
    std::atomic<bool> is_shared = false;
    Pool<std::atomic<int>> pool([&] {
        ++made;
        return std::make_unique<std::atomic<int>>(0);
    });
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int k = 0; k < 2000; ++k)
                pool.use([&](std::atomic<int>& users) {
                    if (++users != 1) is_shared = true;
                    --users;
                });
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(!is_shared);
    CHECK(made <= 4);
}
