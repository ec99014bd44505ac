// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/series.h"

#include <fmt/core.h>

#include <utility>

#include "io/surface_mesh.h"

namespace dsc::fluid_app {

namespace {

io::PolyData poly_data(const Frame& frame) {
    io::PolyData data{.points = frame.surface.vertices};
    for (const auto& [a, b, c] : frame.surface.triangles) data.polygons.push_back({a, b, c});
    io::VtkData velocity{.name = "velocity", .components = 3};
    for (const Point3& u : frame.velocities) velocity.values.insert(velocity.values.end(), u.begin(), u.end());
    data.point_data.push_back(std::move(velocity));
    data.cell_data.push_back({.name = "pressure", .values = frame.pressures});
    return data;
}

}  // namespace

Frame frame_of(const TrackedFluid& fluid, double time) {
    const fluid::FlowState<3>& state = fluid.fluid();
    Frame frame{.time = time};
    std::vector<std::uint32_t> number(state.mesh.positions.size(), 0);
    for (const auto& facet : fluid::facets(state.mesh)) {
        if (facet.opposite) continue;
        auto triangle = facet.vertices;
        for (std::uint32_t& v : triangle) {
            if (number[v] == 0) {
                frame.surface.vertices.push_back(state.mesh.positions[v]);
                frame.velocities.push_back(state.velocities[v]);
                number[v] = static_cast<std::uint32_t>(frame.surface.vertices.size());
            }
            v = number[v] - 1;
        }
        frame.surface.triangles.push_back(triangle);
        frame.pressures.push_back(state.pressures[facet.cell]);
    }
    return frame;
}

Series::Series(std::filesystem::path folder, double until, int count)
    : folder_(std::move(folder)), interval_(count > 1 ? until / (count - 1) : until) {
    if (count > 0) files_.emplace(folder_, "series");
}

void Series::keep(Frame frame) {
    files_->add(frame.time, poly_data(frame));
    io::write_surface_mesh(folder_ / fmt::format("surface_{:04}.obj", frames_.size()), frame.surface);
    frames_.push_back(std::move(frame));
}

void Series::add(const TrackedFluid& fluid, double time) {
    if (!files_) return;
    if (frames_.empty() || time >= static_cast<double>(frames_.size()) * interval_ * (1 - 1e-12))
        keep(frame_of(fluid, time));
}

void Series::add_last(const TrackedFluid& fluid, double time) {
    if (files_ && (frames_.empty() || frames_.back().time != time)) keep(frame_of(fluid, time));
}

void Series::restore(Frame frame) {
    if (files_) keep(std::move(frame));
}

io::ViewSurfaceSeries Series::view() const {
    io::ViewSurfaceSeries series{.name = "surface", .colour = "#4a90c2"};
    for (const Frame& frame : frames_) {
        series.times.push_back(frame.time);
        series.frames.push_back({frame.surface.vertices, frame.surface.triangles});
    }
    return series;
}

}  // namespace dsc::fluid_app
