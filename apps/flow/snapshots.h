// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a flow in space at chosen times: the triangles between each two labels.
#pragma once

#include <string>
#include <vector>

#include "apps/flow/report.h"
#include "apps/flow/snapshot_frames.h"
#include "dsc3d/mesh.h"
#include "geometry/interface_data.h"
#include "io/html_view.h"
#include "io/vtp.h"

namespace dsc::flow {

struct DrawnSurface {
    using Mesh = dsc3d::Mesh;
    using Interface = geometry::InterfaceData;
    static Interface interface(const Mesh& mesh);
    static io::PolyData poly_data(const Interface& interface);
};

class Snapshots : public SnapshotFrames<DrawnSurface> {
public:
    using SnapshotFrames::SnapshotFrames;

    /// One surface for each pair of labels that meet.
    std::vector<io::ViewSurfaceSeries> series() const;
};

/// The page: the interface over time with a slider, the figures at start and end.
io::HtmlPage html_page(const FlowResult& result, const Snapshots& snapshots, const std::string& title);

}  // namespace dsc::flow
