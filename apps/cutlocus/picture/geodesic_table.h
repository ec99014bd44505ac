// SPDX-License-Identifier: GPL-3.0-or-later
// The minimising geodesic from p to any place of the chart: the nearest sample of a fan of geodesics and the
// second-order expansion of the exponential map there; Newton's method where that is not small against the first order.
//
// Guarantee: an error of the order of the cube of the spacing; of the spacing next to conjugate points on the cut
// locus. Cost: a search among the samples and an evaluation of the metric; a few integrations near p and near conjugate
// points.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "apps/cutlocus/picture/chart_box.h"
#include "apps/cutlocus/picture/geodesic_fan.h"

namespace dsc::cutlocus {

class GeodesicTable {
public:
    /// `spacing`: of the samples, on the surface. `metric` must outlive the table.
    GeodesicTable(const geodesic::Metric& metric, const geodesic::Point2& p, const CutDistance& cut, double spacing);

    struct Answer {
        double theta = 0;
        double distance = 0;
    };
    Answer geodesic_to(const geodesic::Point2& x);
    /// The same for a vertex of a front: one that was stopped keeps its own geodesic, which is one of several.
    Answer geodesic_to_vertex(const geodesic::Point2& x);
    /// Makes the stopped vertices of `front` known.
    void add_stops(const FrontResult& front);
    /// The geodesic as a line from p.
    Polyline line(const Answer& answer, double spacing);

private:
    struct Candidate {
        std::uint32_t sample;
        double distance;  // from the place asked for
    };
    static constexpr int cells = 96;  // of the grid, in each direction

    geodesic::Point2 grid_place(const geodesic::Point2& x) const;
    std::vector<Candidate> candidates(const geodesic::Point2& x) const;
    std::optional<Answer> from_sample(const geodesic::GeodesicState& sample, const geodesic::Point2& x);

    const geodesic::Metric& metric_;
    geodesic::GeodesicFlow flow_;
    /// A place that is the same up to rounding, whatever its period.
    std::pair<long, long> key(const geodesic::Point2& x) const;

    double spacing_;
    std::vector<geodesic::GeodesicState> samples_;
    geodesic::Point2 lower_, size_;                 // of the grid
    std::vector<std::vector<std::uint32_t>> grid_;  // samples of each cell, row by row
    std::map<std::pair<long, long>, Answer> stops_;
};

}  // namespace dsc::cutlocus
