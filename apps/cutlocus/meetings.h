// SPDX-License-Identifier: GPL-3.0-or-later
// The meetings that the contacts of the front announce, and only those of minimising geodesics.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "apps/cutlocus/gluing.h"
#include "geodesic/meeting.h"

namespace dsc::cutlocus {

/// A meeting, and whether a contact of the front announced it.
struct FoundMeeting : geodesic::Meeting {
    bool is_announced = true;
};

/// The meeting of each contact, within about `tolerance` (on the surface); left out are contacts without
/// one, with one further away than `largest_shift` (on the surface), or with one that lies on top of another.
std::vector<FoundMeeting> draft_meetings(const geodesic::Metric& metric, const geodesic::Point2& origin,
                                         std::span<const DirectionPair> contacts, double largest_shift,
                                         double tolerance, int threads);

/// Directions and lattice vectors of meetings, for the gluing.
std::vector<DirectionPair> pairs_of(std::span<const FoundMeeting> meetings);

/// Takes out the meetings that a third geodesic reaches earlier: beyond a branch point the bisector of two sheets is no
/// longer a part of the cut locus. Competitors are the partners of the neighbours on the circle of directions.
void remove_overtaken(const geodesic::Metric& metric, const geodesic::Point2& origin,
                      std::vector<FoundMeeting>& meetings, std::span<const double> free_directions, double tolerance);

/// A meeting on an end of the cut locus that no contact announced, because it is shorter than the front's spacing:
/// where the arc from `before` to `after` is broken, one of its geodesics passes a conjugate point. Empty if there is
/// none.
std::optional<FoundMeeting> hidden_meeting(geodesic::GeodesicFlow& flow, const geodesic::Meeting& before,
                                           const geodesic::Meeting& after);

}  // namespace dsc::cutlocus
