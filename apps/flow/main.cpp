// SPDX-License-Identifier: GPL-3.0-or-later
// The program flow: see `flow --help`.
#include <fmt/core.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "apps/common/progress.h"
#include "apps/common/run_main.h"
#include "apps/flow/flow.h"
#include "apps/flow/initial_mesh.h"
#include "apps/flow/output.h"
#include "apps/flow/passes.h"
#include "apps/flow/planar/program.h"
#include "apps/flow/resume.h"
#include "apps/flow/sizing.h"
#include "apps/flow/targets.h"
#include "core/errors.h"
#include "dsc3d/deform/deformer.h"
#include "dsc3d/interface.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"

namespace dsc::flow {

namespace {

void write_results(const Options& options, const dsc3d::Mesh& mesh, const FlowResult& result,
                   const Snapshots& snapshots) {
    const std::filesystem::path folder = options.folder;
    io::write_surface_mesh(folder / "final.obj", dsc3d::Interface(mesh).data.surface);
    io::write_tet_mesh(folder / "final.mesh", mesh.data());
    write_reports(options, report_json(result, options.given),
                  [&](const std::string& title) { return html_page(result, snapshots, title); });
}

dsc3d::DeformParameters deformation(const Options& options, double edge_length) {
    dsc3d::DeformParameters parameters{.edge_length = edge_length,
                                       .seed = static_cast<std::uint64_t>(options.common.seed),
                                       .topology = options.topology};
    switch_off(options.without, parameters);
    return parameters;
}

Targets motion_of(const Options& options, const FlowResult& result) {
    Targets motion = motion_targets(options.motion, result.domain, result.time.until);
    return options.sizing ? with_sizing(std::move(motion), *options.sizing, result.edge_length) : motion;
}

// From where `result`, `snapshots` and `checkpoints` are to the end.
int finish(const Options& options, const Targets& targets, dsc3d::Mesh& mesh, FlowResult& result, Snapshots& snapshots,
           Checkpoints& checkpoints, apps::ProgressObserver& observer) {
    remove_unfinished_files(options.folder);
    run_flow(mesh, deformation(options, result.edge_length), targets, snapshots, observer, result, &checkpoints,
             domain_walls(options.shape));
    write_results(options, mesh, result, snapshots);
    observer.clear();
    if (!options.common.quiet) fmt::print("{}", report_text(result));
    require_end(result.end, result.reason, options.folder, checkpoints.state().has_value());
    return apps::exit_done;
}

int start(const Options& options) {
    if (options.shape.shape == Shape::file) require_other_files(options.shape.path, options.folder);
    apps::ProgressObserver observer(options.common.progress);
    const InitialMesh initial = initial_mesh(options.shape, observer);
    FlowResult result{
        .domain = initial.domain, .edge_length = initial.edge_length, .time = time_steps(options.time, options.motion)};
    const Targets targets = motion_of(options, result);
    dsc3d::Mesh mesh(initial.data);
    if (initial.may_be_too_fine) {
        dsc3d::Deformer(mesh, deformation(options, result.edge_length)).coarsen_everywhere();
        mesh = dsc3d::Mesh(mesh.data());
    }
    remove_checkpoint(options.folder);
    Checkpoints checkpoints(apps::checkpoint_path(options.folder), checkpoint_kind, options.given,
                            options.checkpoint_interval);
    Snapshots snapshots(options.folder, result.time.count, options.snapshots);
    return finish(options, targets, mesh, result, snapshots, checkpoints, observer);
}

int resume(const Options& options, apps::CheckpointFile& file) {
    SavedRun saved = file.run<SavedRun>();
    apps::ProgressObserver observer(options.common.progress);
    FlowResult result;
    result.domain = saved.state.domain;
    result.edge_length = saved.state.edge_length;
    result.time = time_steps(options.time, options.motion);
    const Targets targets = motion_of(options, result);
    const std::filesystem::path path = apps::checkpoint_path(options.folder);
    dsc3d::Mesh mesh(saved.state.tets, path.string());
    Checkpoints checkpoints(path, checkpoint_kind, options.given, options.checkpoint_interval);
    Snapshots snapshots(options.folder, result.time.count, options.snapshots);
    take_over(std::move(saved), result, snapshots, checkpoints);
    return finish(options, targets, mesh, result, snapshots, checkpoints, observer);
}

int run(int argc, const char* const* argv) {
    std::optional<Options> options = parse_options(argc, argv);
    if (!options) return apps::exit_done;
    if (!options->is_resumed) return options->planar ? planar::start(*options) : start(*options);
    apps::CheckpointFile file(apps::checkpoint_path(options->folder), checkpoint_kind);
    options = resumed_options(file.options(), *options);
    return options->planar ? planar::resume(*options, file) : resume(*options, file);
}

}  // namespace

}  // namespace dsc::flow

int main(int argc, char** argv) {
    return dsc::apps::run_main("flow", [&] { return dsc::flow::run(argc, argv); });
}
