// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/vertex_merger.h"

#include <bit>

#include "core/assert.h"

namespace dsc::io::surface {

namespace {

std::uint64_t hash(const Eigen::Vector3d& place) {
    std::uint64_t value = 0;
    for (const double x : place) {
        // Adding 0 makes 0 of -0. The rest is the finalizer of splitmix64: neighbours of a grid differ in few bits.
        value = (value ^ std::bit_cast<std::uint64_t>(x + 0.0)) + 0x9e3779b97f4a7c15;
        value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9;
        value = (value ^ value >> 27) * 0x94d049bb133111eb;
        value ^= value >> 31;
    }
    return value;
}

}  // namespace

std::uint32_t VertexMerger::number(const Eigen::Vector3d& place) {
    std::uint32_t& taken = slot(place);
    if (taken != empty) return taken;
    DSC_ASSERT(places_.size() < empty);
    const auto number = static_cast<std::uint32_t>(places_.size());
    taken = number;
    places_.push_back(place);
    if (2 * places_.size() > slots_.size()) grow();
    return number;
}

std::uint32_t& VertexMerger::slot(const Eigen::Vector3d& place) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash(place) & mask;
    while (slots_[i] != empty && places_[slots_[i]] != place) i = (i + 1) & mask;
    return slots_[i];
}

void VertexMerger::grow() {
    slots_.assign(2 * slots_.size(), empty);
    for (std::uint32_t i = 0; i < places_.size(); ++i) slot(places_[i]) = i;
}

}  // namespace dsc::io::surface
