// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers places in the order in which they come, equal coordinates once.
// Guarantee: compares coordinates as numbers (0 and -0 are equal); the first of equal places is kept. Cost: constant
// per place on average, 4 to 8 bytes per different place beside the places themselves.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

namespace dsc::io::surface {

class VertexMerger {
public:
    VertexMerger() : slots_(16, empty) {}

    /// The number of the place, which is that of places().back() when it is new. Coordinates have to be finite.
    std::uint32_t number(const Eigen::Vector3d& place);

    const std::vector<Eigen::Vector3d>& places() const& { return places_; }
    std::vector<Eigen::Vector3d> places() && { return std::move(places_); }

private:
    static constexpr std::uint32_t empty = ~std::uint32_t{0};

    /// Where the place is, or belongs when it is new.
    std::uint32_t& slot(const Eigen::Vector3d& place);
    void grow();

    std::vector<Eigen::Vector3d> places_;
    std::vector<std::uint32_t> slots_;  // a power of two of them, at most half of them taken
};

}  // namespace dsc::io::surface
