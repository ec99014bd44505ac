// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handles.h"

#include <catch2/catch.hpp>
#include <type_traits>
#include <unordered_set>

using namespace dsc::core;

// A handle of one kind of simplex is not a handle of another one, nor an integer.
static_assert(!std::is_convertible_v<EdgeId, VertexId> && !std::is_constructible_v<VertexId, EdgeId>);
static_assert(!std::is_convertible_v<std::uint32_t, VertexId> && !std::is_convertible_v<VertexId, std::uint32_t>);
static_assert(sizeof(TetId) == 4 && std::is_trivially_copyable_v<TetId>);

TEST_CASE("a default handle is invalid, any other is valid") {
    CHECK_FALSE(VertexId().is_valid());
    CHECK(VertexId(0).is_valid());
    CHECK(FaceId(12).index() == 12);
}

TEST_CASE("handles are ordered and hashed by index") {
    CHECK(VertexId(1) < VertexId(2));
    CHECK(VertexId(3) == VertexId(3));
    const std::unordered_set<EdgeId> edges{EdgeId(1), EdgeId(2), EdgeId(1)};
    CHECK(edges.size() == 2);
}
