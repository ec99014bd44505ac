// SPDX-License-Identifier: GPL-3.0-or-later
// Whether closed polygons in the plane are simple and keep apart from each other.
// Source: orientation predicates (geometry/predicates.h) on the pairs of sides whose boxes meet, found by a sweep over
// the first coordinate. Guarantee: exact. Cost: n log n for n sides, and the pairs of sides that overlap in x.
//
//     if (const auto meeting = geometry::first_meeting(polygons)) complain(meeting->place);
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/predicates.h"

namespace dsc::geometry {

/// Side i of a polygon goes from corner i to the next one.
struct PolygonSide {
    std::uint32_t polygon, side;
};

struct SideMeeting {
    PolygonSide first, second;
    Point2 place;  ///< rounded
};

/// Two sides that meet elsewhere than in the corner between neighbours, if there are any: the first pair in the order
/// of polygons and sides. A side of no length meets its neighbour. Precondition: at least three corners each.
std::optional<SideMeeting> first_meeting(std::span<const std::vector<Point2>> polygons);

/// Twice the area is positive for corners that go round counterclockwise.
double signed_area(std::span<const Point2> polygon);

/// True when the place lies inside a simple polygon; on a side, either answer may come.
bool contains(std::span<const Point2> polygon, const Point2& place);

}  // namespace dsc::geometry
