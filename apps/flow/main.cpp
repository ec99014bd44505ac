// SPDX-License-Identifier: GPL-3.0-or-later
// The program flow: see `flow --help`.
#include <fmt/core.h>

#include <filesystem>

#include "apps/common/progress.h"
#include "apps/common/run_main.h"
#include "apps/flow/flow.h"
#include "apps/flow/initial_mesh.h"
#include "apps/flow/output.h"
#include "apps/flow/planar/program.h"
#include "apps/flow/targets.h"
#include "core/errors.h"
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

int run(int argc, const char* const* argv) {
    const std::optional<Options> options = parse_options(argc, argv);
    if (!options) return apps::exit_done;
    if (options->sizing) throw core::UsageError("--sizing is not there yet");
    if (options->is_resumed) throw core::UsageError("--resume is not there yet");
    if (options->planar) return planar::run(*options);
    if (options->topology != motion::TopologyPolicy::preserved)
        throw core::UsageError("--topology: only preserved is there yet; interfaces that meet are stopped");
    if (options->shape.shape == Shape::file) require_other_files(options->shape.path, options->folder);
    apps::ProgressObserver observer(options->common.progress);
    const InitialMesh initial = initial_mesh(options->shape, observer);
    FlowResult result{.domain = initial.domain,
                      .edge_length = initial.edge_length,
                      .time = time_steps(options->time, options->motion)};
    const Targets targets = motion_targets(options->motion, initial.domain, result.time.until);
    dsc3d::Mesh mesh(initial.data);
    dsc3d::Deformer deformer(mesh, {.edge_length = initial.edge_length});
    Snapshots snapshots(options->folder, result.time.count, options->snapshots);
    run_flow(mesh, deformer, targets, snapshots, observer, result);
    write_results(*options, mesh, result, snapshots);
    observer.clear();
    if (!options->common.quiet) fmt::print("{}", report_text(result));
    require_end(result.end, result.reason, options->folder);
    return apps::exit_done;
}

}  // namespace

}  // namespace dsc::flow

int main(int argc, char** argv) {
    return dsc::apps::run_main("flow", [&] { return dsc::flow::run(argc, argv); });
}
