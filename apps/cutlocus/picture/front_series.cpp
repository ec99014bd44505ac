// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/front_series.h"

#include <utility>

#include "apps/cutlocus/picture/geodesic_table.h"
#include "apps/cutlocus/picture/svg_front.h"
#include "core/errors.h"
#include "io/vtp.h"

namespace dsc::cutlocus {

using geodesic::Metric;
using geodesic::Point2;

void write_front_series(const std::filesystem::path& folder, const Metric& metric, const Point2& p,
                        const FrontResult& front) {
    if (front.snapshots.empty()) throw core::UsageError("a series of the front needs snapshots of it");
    io::PvdSeries series(folder, "front");
    const CutDistance cut(front);
    GeodesicTable table(metric, p, cut, cut.limit() / 100);
    table.add_stops(front);
    for (const FrontSnapshot& snapshot : front.snapshots) {
        Polyline line = front_line(snapshot, metric.periods());
        line.pop_back();
        io::PolyData data;
        io::VtkData chart{"chart", 2, {}}, distance{"distance", 1, {}}, theta{"theta", 1, {}};
        std::vector<std::uint32_t> loop;
        for (const Point2& x : line) {
            loop.push_back(static_cast<std::uint32_t>(data.points.size()));
            data.points.push_back(metric.position(x).value_or(geodesic::Point3(x.x(), x.y(), 0)));
            const GeodesicTable::Answer answer = table.geodesic_to_vertex(x);
            chart.values.insert(chart.values.end(), {x.x(), x.y()});
            distance.values.push_back(answer.distance);
            theta.values.push_back(answer.theta);
        }
        loop.push_back(0);
        data.lines.push_back(std::move(loop));
        data.point_data = {std::move(chart), std::move(distance), std::move(theta)};
        series.add(snapshot.t, data);
    }
}

}  // namespace dsc::cutlocus
