// SPDX-License-Identifier: GPL-3.0-or-later
// The program fluid: see `fluid --help`.
#include <fmt/core.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "apps/common/progress.h"
#include "apps/common/resumed_arguments.h"
#include "apps/common/run_main.h"
#include "apps/fluid/initial_mesh.h"
#include "apps/fluid/options.h"
#include "apps/fluid/report.h"
#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/tet_mesh.h"

namespace dsc::fluid_app {

namespace {

TrackedParameters parameters_of(const Options& options, double edge_length) {
    const Scene& scene = options.scene;
    TrackedParameters parameters{.container = Container(scene)};
    fluid::FlowParameters<3>& flow = parameters.flow;
    flow.fluid.phases = {{.density = scene.density, .viscosity = scene.viscosity}};
    flow.fluid.gravity = scene.gravity;
    flow.fluid.has_second_order_tension = options.has_second_order_tension;
    flow.tensions = {.free_surface = {scene.tension}, .wetting = scene.wetting};
    if (options.stabilization) flow.fluid.stabilization = *options.stabilization;
    if (options.compensation) flow.compensation = *options.compensation;
    if (options.capillary_share) flow.capillary_share = *options.capillary_share;
    parameters.deform.edge_length = edge_length;
    parameters.deform.growth = tracked_growth;
    parameters.deform.seed = static_cast<std::uint64_t>(options.common.seed);
    parameters.conserves_momentum = options.conserves_momentum;
    return parameters;
}

int finish(const Options& options, const TrackedState& start, double edge_length, Series& series,
           Checkpoints& checkpoints, apps::ProgressObserver& observer, RunResult& result) {
    const std::filesystem::path folder = options.folder;
    const geometry::TetData last =
        run_fluid(start, parameters_of(options, edge_length), options.run, series, &checkpoints, observer, result);
    io::write_tet_mesh(folder / "final.mesh", last);
    const std::string report = report_json(options.scene, result, options.given).dump(1) + "\n";
    io::write_file(folder / "report.json", report);
    if (options.common.json) io::write_file(*options.common.json, report);
    if (options.snapshots > 0) io::write_html_page(folder / "index.html", html_page(options.scene, result, series));
    observer.clear();
    if (!options.common.quiet) fmt::print("{}", report_text(result));
    if (result.end == RunEnd::stopped || result.end == RunEnd::cancelled)
        throw core::RunError(result.reason + "; " + options.folder + " has the state before");
    return apps::exit_done;
}

int start(const Options& options) {
    apps::ProgressObserver observer(options.common.progress);
    InitialMesh mesh = initial_mesh(options.scene, observer);
    TrackedState state{.tets = std::move(mesh.tets), .velocities = std::move(mesh.velocities)};
    const std::filesystem::path path = apps::checkpoint_path(options.folder);
    std::filesystem::remove(path);  // of an earlier run
    Checkpoints checkpoints(path, checkpoint_kind, options.given, options.checkpoint_interval);
    Series series(options.folder, options.run.until, options.snapshots);
    RunResult result;
    return finish(options, state, mesh.edge_length, series, checkpoints, observer, result);
}

int resume(const Options& resuming) {
    const std::filesystem::path path = apps::checkpoint_path(resuming.folder);
    apps::CheckpointFile file(path, checkpoint_kind);
    const apps::ResumedArguments arguments("fluid", file.options(), resuming.given);
    std::optional<Options> options = parse_options(arguments.argc(), arguments.argv());
    options->given = file.options();
    SavedRun saved = file.run<SavedRun>();
    const double edge_length = saved.state.edge_length;
    apps::ProgressObserver observer(options->common.progress);
    RunResult result{
        .steps = std::move(saved.steps), .events = std::move(saved.events), .seconds = saved.state.seconds};
    Series series(options->folder, options->run.until, options->snapshots);
    for (Frame& frame : saved.frames) series.restore(std::move(frame));
    Checkpoints checkpoints(path, checkpoint_kind, options->given, options->checkpoint_interval);
    checkpoints.restore(std::move(saved.state));
    return finish(*options, {}, edge_length, series, checkpoints, observer, result);
}

int run(int argc, const char* const* argv) {
    const std::optional<Options> options = parse_options(argc, argv);
    if (!options) return apps::exit_done;
    return options->is_resumed ? resume(*options) : start(*options);
}

}  // namespace

}  // namespace dsc::fluid_app

int main(int argc, char** argv) {
    return dsc::apps::run_main("fluid", [&] { return dsc::fluid_app::run(argc, argv); });
}
