// SPDX-License-Identifier: GPL-3.0-or-later
// The interface in the plane at chosen times: a series for ParaView, written as it grows, and the frames of the page.
// Guarantee: the first and the last state are among them; the rest is evenly spaced over the steps. On a torus, a curve
// is drawn in one piece from the period of the domain in which it begins. Cost: linear in the mesh for each of them.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "apps/flow/planar/report.h"
#include "apps/flow/snapshot_times.h"
#include "dsc2d/complex.h"
#include "io/html_view.h"
#include "io/vtp.h"

namespace dsc::flow::planar {

/// The curves of the interface as polylines, with "left_label" and "right_label".
io::PolyData curve_data(const dsc2d::Complex& complex);

class Snapshots {
public:
    /// Writes to FOLDER/series.pvd when `count` is positive.
    Snapshots(const std::filesystem::path& folder, int steps, int count);

    /// Keeps the state if its time has come; precondition: steps in ascending order.
    void add(const dsc2d::Complex& complex, int step, double time);
    /// Keeps it in any case: the last state of a run that ended early.
    void add_last(const dsc2d::Complex& complex, int step, double time);

    /// Lines for each pair of labels that meet.
    std::vector<io::ViewSeries> series() const;

private:
    using Lines = std::map<std::array<int, 2>, std::vector<io::ViewLine>>;  ///< by the labels right and left
    void keep(const dsc2d::Complex& complex, double time);

    SnapshotTimes times_to_keep_;
    std::optional<io::PvdSeries> files_;
    std::vector<double> times_;
    std::vector<Lines> frames_;
};

/// The page: the interface over time with a slider, the mesh at the end, the figures at start and end.
io::HtmlPage html_page(const FlowResult& result, const dsc2d::Complex& last, const Snapshots& snapshots,
                       const std::string& title);

}  // namespace dsc::flow::planar
