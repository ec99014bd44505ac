// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/stages.h"

#include <fmt/core.h>

#include <algorithm>

namespace dsc::reconstruct {

namespace {

io::PolyData poly_data(const geometry::SurfaceData& surface) {
    io::PolyData data{.points = surface.vertices};
    for (const auto& [a, b, c] : surface.triangles) data.polygons.push_back({a, b, c});
    return data;
}

io::ViewSurface residual_view(const Reconstruction& result) {
    io::ViewSurface view{.name = "surface", .vertices = result.surface.vertices, .triangles = result.surface.triangles};
    for (const double distance : result.vertex_distance) {
        const double share = std::min(1.0, 0.5 * distance / result.spacing);
        view.colours.emplace_back(1, 1 - 0.75 * share, 1 - 0.85 * share);
    }
    return view;
}

io::ViewPoints point_view(const geometry::PointData& cloud, std::size_t most_points) {
    const std::size_t step = (cloud.points.size() + most_points - 1) / most_points;
    io::ViewPoints view{.name = step > 1 ? fmt::format("every {}th point", step) : "points",
                        .colour = "#1f4e9c",
                        .size = 2,
                        .is_visible = false};
    for (std::size_t i = 0; i < cloud.points.size(); i += step) view.positions.push_back(cloud.points[i]);
    return view;
}

}  // namespace

Stages::Stages(const std::optional<std::string>& folder) {
    if (folder) files_.emplace(*folder, "series");
}

void Stages::add(const std::string& stage, const geometry::SurfaceData& surface) {
    if (files_) files_->add(static_cast<double>(stages_.size()), poly_data(surface));
    stages_.push_back({stage, surface});
}

io::HtmlPage html_page(const Reconstruction& result, const geometry::PointData& cloud, const Stages& stages,
                       const std::string& title, const StagesPageParameters& parameters) {
    io::HtmlPage page{.title = title, .shares_camera = true, .time_name = "stage"};
    page.facts = {{"points", std::to_string(result.points)},
                  {"strays", std::to_string(result.strays.size())},
                  {"spacing", fmt::format("{:.4g}", result.spacing)},
                  {"noise", fmt::format("{:.3g}", result.noise)},
                  {"triangles", std::to_string(result.surface.triangles.size())},
                  {"components", std::to_string(result.genus.size())},
                  {"mean residual", fmt::format("{:.3g}", result.residuals.mean)}};
    page.views.push_back({.name = "surface", .surfaces = {residual_view(result)}});
    page.views.front().points.push_back(point_view(cloud, parameters.most_points));
    io::ViewSurfaceSeries series{.name = "stage", .shows_edges = false};
    for (std::size_t i = 0; i < stages.all().size(); ++i) {
        const Stages::Stage& stage = stages.all()[i];
        series.times.push_back(static_cast<double>(i));
        series.frames.push_back({stage.surface.vertices, stage.surface.triangles});
        page.facts.emplace_back(fmt::format("stage {}", i), stage.name);
    }
    if (!series.frames.empty()) {
        io::HtmlView view{.name = "stages"};
        view.surface_series.push_back(std::move(series));
        page.views.push_back(std::move(view));
    }
    return page;
}

}  // namespace dsc::reconstruct
