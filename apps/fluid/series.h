// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of the fluid at evenly spaced times: with velocity and pressure for ParaView, as OBJ files, and as the
// frames of the page. Guarantee: every file appears whole or not at all; the first and the last state are among them.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "apps/fluid/tracked_fluid.h"
#include "core/fields.h"
#include "geometry/surface_data.h"
#include "io/html_view.h"
#include "io/vtp.h"

namespace dsc::fluid_app {

struct Frame {
    double time = 0;
    geometry::SurfaceData surface;
    std::vector<Point3> velocities;  ///< of its vertices
    std::vector<double> pressures;   ///< of the cells behind its triangles
};

template <class Visitor, core::ConstOrNot<Frame> Value>
void fields(Visitor& visitor, Value& frame) {
    auto& [time, surface, velocities, pressures] = frame;
    visitor(time, surface, velocities, pressures);
}

Frame frame_of(const TrackedFluid& fluid, double time);

class Series {
public:
    /// Writes to FOLDER/series.pvd and FOLDER/surface_0000.obj, …, when `count` is positive: about so many states until
    /// the end.
    Series(std::filesystem::path folder, double until, int count);

    /// Keeps the state if its time has come.
    void add(const TrackedFluid& fluid, double time);
    /// Keeps it unless that is done.
    void add_last(const TrackedFluid& fluid, double time);
    /// What an earlier part of the run has kept: its files are written again.
    void restore(Frame frame);

    const std::vector<Frame>& frames() const { return frames_; }
    io::ViewSurfaceSeries view() const;

private:
    void keep(Frame frame);

    std::filesystem::path folder_;
    double interval_;
    std::optional<io::PvdSeries> files_;
    std::vector<Frame> frames_;
};

}  // namespace dsc::fluid_app
