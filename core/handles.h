// SPDX-License-Identifier: GPL-3.0-or-later
// Typed handles of simplices: distinct 32-bit integers, so that an edge can't be passed for a vertex.
// Guarantee: trivially copyable, totally ordered, hashable; a default-constructed handle is invalid.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <limits>

namespace dsc::core {

template <class Simplex>
class Handle {
public:
    constexpr Handle() = default;
    explicit constexpr Handle(std::uint32_t index) : index_(index) {}

    constexpr std::uint32_t index() const { return index_; }
    constexpr bool is_valid() const { return index_ != invalid_index; }
    constexpr auto operator<=>(const Handle&) const = default;

private:
    static constexpr std::uint32_t invalid_index = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t index_ = invalid_index;
};

using VertexId = Handle<struct VertexTag>;
using HalfedgeId = Handle<struct HalfedgeTag>;
using EdgeId = Handle<struct EdgeTag>;
using FaceId = Handle<struct FaceTag>;
using TetId = Handle<struct TetTag>;

}  // namespace dsc::core

template <class Simplex>
struct std::hash<dsc::core::Handle<Simplex>> {
    std::size_t operator()(dsc::core::Handle<Simplex> handle) const noexcept {
        return std::hash<std::uint32_t>{}(handle.index());
    }
};
