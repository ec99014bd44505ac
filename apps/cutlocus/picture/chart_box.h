// SPDX-License-Identifier: GPL-3.0-or-later
// The rectangle of the chart that a picture shows, and how curves of the universal cover appear in it: cut at the
// seams, each part moved into the rectangle by whole periods.
//
// Guarantee: nothing leaves the rectangle by more than a millionth of its sides, and no line leads across it from one
// side of a seam to the other. What lies on a seam is seen on both sides of it.
#pragma once

#include <span>
#include <vector>

#include "apps/cutlocus/picture/polyline.h"

namespace dsc::cutlocus {

class ChartBox {
public:
    /// One period around `center` where the chart is periodic; elsewhere what the points of `lines` need, with a
    /// margin.
    ChartBox(const geodesic::ChartPeriods& periods, const geodesic::Point2& center, std::span<const Polyline> lines);

    const geodesic::Point2& lower() const { return lower_; }
    const geodesic::Point2& upper() const { return upper_; }
    const geodesic::ChartPeriods& periods() const { return periods_; }

    /// What is seen of a line of the universal cover, moved by all periods that bring a part of it into the box.
    std::vector<Polyline> pieces(std::span<const geodesic::Point2> line) const;
    /// What is seen of the line as it is, not moved.
    std::vector<Polyline> clipped(std::span<const geodesic::Point2> line) const;
    /// The places in the box where `point` is seen: more than one on a seam.
    std::vector<geodesic::Point2> places(const geodesic::Point2& point) const;
    /// The line in one run, moved into the box: where it crosses a seam come the point where it leaves, a point that is
    /// not a number, and the point where it enters again.
    Polyline wrapped(std::span<const geodesic::Point2> line) const;

private:
    template <class Function>
    void for_each_translation(std::span<const geodesic::Point2> line, Function&& use) const;

    geodesic::ChartPeriods periods_;
    geodesic::Point2 lower_, upper_;
    geodesic::Vector2 rim_;  // what lies this near to a seam is on it
};

}  // namespace dsc::cutlocus
