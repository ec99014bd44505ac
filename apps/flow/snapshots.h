// SPDX-License-Identifier: GPL-3.0-or-later
// The interface at chosen times: a series for ParaView, written as it grows, and the frames of the page.
// Guarantee: the first and the last state are among them; the rest is evenly spaced over the steps.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "apps/flow/report.h"
#include "apps/flow/snapshot_times.h"
#include "dsc3d/mesh.h"
#include "geometry/interface_data.h"
#include "io/html_view.h"
#include "io/vtp.h"

namespace dsc::flow {

class Snapshots {
public:
    /// Writes to FOLDER/series.pvd when `count` is positive.
    Snapshots(const std::filesystem::path& folder, int steps, int count);

    /// Keeps the state if its time has come; precondition: steps in ascending order.
    void add(const dsc3d::Mesh& mesh, int step, double time);
    /// Keeps it in any case: the last state of a run that ended early.
    void add_last(const dsc3d::Mesh& mesh, int step, double time);

    struct Frame {
        int step;
        double time;
        geometry::InterfaceData interface;
    };
    /// What an earlier part of the run has kept, in its order: its files are written again.
    void restore(Frame frame);
    const std::vector<Frame>& frames() const { return frames_; }

    /// One surface for each pair of labels that meet.
    std::vector<io::ViewSurfaceSeries> series() const;

private:
    void keep(Frame frame);

    SnapshotTimes times_to_keep_;
    std::optional<io::PvdSeries> files_;
    std::vector<Frame> frames_;
};

/// The page: the interface over time with a slider, the figures at start and end.
io::HtmlPage html_page(const FlowResult& result, const Snapshots& snapshots, const std::string& title);

}  // namespace dsc::flow
