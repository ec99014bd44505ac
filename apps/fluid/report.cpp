// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/report.h"

#include <fmt/core.h>

#include <array>
#include <numeric>

#include "apps/common/names.h"
#include "core/version.h"

namespace dsc::fluid_app {

using io::Json;

namespace {

constexpr std::array end_names{apps::Name{"done", RunEnd::done}, apps::Name{"vanished", RunEnd::vanished},
                               apps::Name{"stopped", RunEnd::stopped}, apps::Name{"cancelled", RunEnd::cancelled}};

Json point_json(const Point3& p) { return Json(std::vector<double>{p.x(), p.y(), p.z()}); }

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double energy(const StepRecord& step) { return step.kinetic_energy + step.surface_energy + step.potential_energy; }

Json step_json(const StepRecord& step) {
    Json milliseconds = Json::object();
    for (const auto& [phase, ms] : step.milliseconds) milliseconds[phase] = ms;
    return Json::object({{"step", step.step},
                         {"time", step.time},
                         {"dt", step.dt},
                         {"vertices", step.vertices},
                         {"cells", step.cells},
                         {"tets", step.tets},
                         {"surface_faces", step.surface_faces},
                         {"volumes", step.volumes},
                         {"kept_volumes", step.kept_volumes},
                         {"centre", point_json(step.centre)},
                         {"momentum", point_json(step.momentum)},
                         {"angular_momentum", point_json(step.angular_momentum)},
                         {"kinetic_energy", step.kinetic_energy},
                         {"surface_energy", step.surface_energy},
                         {"potential_energy", step.potential_energy},
                         {"max_speed", step.max_speed},
                         {"max_divergence", step.max_divergence},
                         {"solver_iterations", step.solver_iterations},
                         {"transferred", step.transferred},
                         {"unfinished", step.unfinished},
                         {"min_dihedral", step.min_dihedral},
                         {"ms", milliseconds}});
}

/// Name and figures of what text and page show.
std::vector<std::array<std::string, 3>> figures(const RunResult& result) {
    const StepRecord &first = result.steps.front(), &last = result.steps.back();
    std::vector<std::array<std::string, 3>> rows;
    const auto add = [&](const std::string& name, const auto& figure) {
        rows.push_back({name, figure(first), figure(last)});
    };
    add("time", [](const StepRecord& step) { return fmt::format("{:.6g}", step.time); });
    add("tetrahedra, of fluid", [](const StepRecord& step) { return fmt::format("{}, {}", step.tets, step.cells); });
    add("parts", [](const StepRecord& step) { return fmt::format("{}", step.volumes.size()); });
    add("volume", [](const StepRecord& step) { return fmt::format("{:.10g}", sum(step.volumes)); });
    add("momentum", [](const StepRecord& step) {
        return fmt::format("{:.6g} {:.6g} {:.6g}", step.momentum.x(), step.momentum.y(), step.momentum.z());
    });
    add("kinetic energy", [](const StepRecord& step) { return fmt::format("{:.6g}", step.kinetic_energy); });
    add("surface energy", [](const StepRecord& step) { return fmt::format("{:.6g}", step.surface_energy); });
    add("energy", [](const StepRecord& step) { return fmt::format("{:.6g}", energy(step)); });
    add("smallest dihedral angle", [](const StepRecord& step) { return fmt::format("{:.2f}°", step.min_dihedral); });
    return rows;
}

}  // namespace

Json report_json(const Scene& scene, const RunResult& result, const Json& given) {
    Json events = Json::array(), steps = Json::array();
    for (const Event& event : result.events)
        events.push_back(Json::object(
            {{"kind", event.kind}, {"step", event.step}, {"time", event.time}, {"place", point_json(event.place)}}));
    for (const StepRecord& step : result.steps) steps.push_back(step_json(step));
    return Json::object({{"program", "fluid"},
                         {"version", core::version()},
                         {"options", given},
                         {"scene", scene.name},
                         {"domain", Json::array({point_json(scene.domain.min()), point_json(scene.domain.max())})},
                         {"edge_length", scene.edge_length},
                         {"density", scene.density},
                         {"tension", scene.tension},
                         {"viscosity", scene.viscosity},
                         {"gravity", point_json(scene.gravity)},
                         {"end", apps::name_of(end_names, result.end)},
                         {"end_reason", result.reason},
                         {"seconds", result.seconds},
                         {"events", events},
                         {"steps", steps}});
}

std::string report_text(const RunResult& result) {
    std::string text = fmt::format("{:<26}{:>28}{:>28}\n", "", "start", "end");
    for (const auto& [name, start, end] : figures(result))
        text += fmt::format("{:<26}{:>28}{:>28}\n", name, start, end);
    return text + fmt::format("{} after {} steps, {} events, {:.1f} s\n", result.reason, result.steps.back().step,
                              result.events.size(), result.seconds);
}

io::HtmlPage html_page(const Scene& scene, const RunResult& result, const Series& series) {
    io::HtmlPage page{.title = "fluid: " + scene.name};
    for (const auto& [name, start, end] : figures(result)) page.facts.emplace_back(name, start + " → " + end);
    page.facts.emplace_back("events", std::to_string(result.events.size()));
    page.facts.emplace_back("end", result.reason);
    io::HtmlView view{.name = "surface"};
    view.surface_series.push_back(series.view());
    page.views.push_back(std::move(view));
    return page;
}

}  // namespace dsc::fluid_app
