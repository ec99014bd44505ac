// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a flow in the plane at chosen times: the curves between each two labels. On a torus, a curve is
// drawn in one piece from the period of the domain in which it begins.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "apps/flow/planar/report.h"
#include "apps/flow/snapshot_frames.h"
#include "core/fields.h"
#include "dsc2d/complex.h"
#include "io/html_view.h"
#include "io/vtp.h"

namespace dsc::flow::planar {

struct DrawnCurve {
    std::array<int, 2> labels;  ///< right and left
    io::ViewLine line;          ///< a closed one ends where it begins, unless that is in another period
};

template <class Visitor, core::ConstOrNot<DrawnCurve> Value>
void fields(Visitor& visitor, Value& curve) {
    auto& [labels, line] = curve;
    visitor(labels, line);
}

struct DrawnCurves {
    using Mesh = dsc2d::Complex;
    using Interface = std::vector<DrawnCurve>;
    static Interface interface(const Mesh& complex);
    /// Polylines with "left_label" and "right_label".
    static io::PolyData poly_data(const Interface& curves);
};

class Snapshots : public SnapshotFrames<DrawnCurves> {
public:
    using SnapshotFrames::SnapshotFrames;

    /// Lines for each pair of labels that meet.
    std::vector<io::ViewSeries> series() const;
};

/// The page: the interface over time with a slider, the mesh at the end, the figures at start and end.
io::HtmlPage html_page(const FlowResult& result, const dsc2d::Complex& last, const Snapshots& snapshots,
                       const std::string& title);

}  // namespace dsc::flow::planar
