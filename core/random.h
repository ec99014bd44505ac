// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded random numbers with the same bits on every platform (std::uniform_*_distribution does not promise that).
#pragma once

#include <cstdint>
#include <random>

namespace dsc::core {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, 1), with 53 random bits.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// Uniform in {0, …, count - 1}; count > 0. The bias is below count / 2^64.
    std::uint64_t below(std::uint64_t count) { return engine_() % count; }

private:
    std::mt19937_64 engine_;
};

}  // namespace dsc::core
