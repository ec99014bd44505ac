// SPDX-License-Identifier: GPL-3.0-or-later
// The program flow: see `flow --help`.
#include <fmt/core.h>

#include <filesystem>

#include "apps/common/progress.h"
#include "apps/common/run_main.h"
#include "apps/flow/flow.h"
#include "apps/flow/initial_mesh.h"
#include "apps/flow/planar/program.h"
#include "apps/flow/targets.h"
#include "core/errors.h"
#include "dsc3d/interface.h"
#include "io/atomic_file.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"

namespace dsc::flow {

namespace {

// The natural name for going on from a result would be lost with it.
void require_other_files(const Options& options) {
    if (options.shape.shape != Shape::file) return;
    const std::filesystem::path folder = options.folder;
    for (const char* name : {"final.obj", "final.mesh"}) {
        std::error_code absent;
        if (std::filesystem::equivalent(options.shape.path, folder / name, absent))
            throw core::UsageError(options.shape.path +
                                   " would be overwritten by the result; choose another folder for -o");
    }
}

// What an earlier run has left and this one does not replace would be taken for its own.
void remove_earlier_series(const std::filesystem::path& folder) {
    for (const char* name : {"series.pvd", "index.html"}) {
        std::error_code absent;
        std::filesystem::remove(folder / name, absent);
    }
}

// The last name of the path, also of one that ends in a slash or is a dot.
std::string name_of_folder(const std::filesystem::path& folder) {
    std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
    if (path.filename().empty()) path = path.parent_path();
    return path.filename().string();
}

void write_results(const Options& options, const dsc3d::Mesh& mesh, const FlowResult& result,
                   const Snapshots& snapshots) {
    const std::filesystem::path folder = options.folder;
    io::write_surface_mesh(folder / "final.obj", dsc3d::Interface(mesh).data.surface);
    io::write_tet_mesh(folder / "final.mesh", mesh.data());
    const std::string report = report_json(result, options.given).dump(1) + "\n";
    io::write_file(folder / "report.json", report);
    if (options.common.json) io::write_file(*options.common.json, report);
    if (options.snapshots > 0) {
        io::write_html_page(folder / "index.html", html_page(result, snapshots, name_of_folder(folder)));
    } else {
        remove_earlier_series(folder);
    }
}

int run(int argc, const char* const* argv) {
    const std::optional<Options> options = parse_options(argc, argv);
    if (!options) return apps::exit_done;
    if (options->sizing) throw core::UsageError("--sizing is not there yet");
    if (options->is_resumed) throw core::UsageError("--resume is not there yet");
    if (options->planar) return planar::run(*options);
    if (options->topology != motion::TopologyPolicy::preserved)
        throw core::UsageError("--topology: only preserved is there yet; interfaces that meet are stopped");
    require_other_files(*options);
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
    if (result.end == FlowEnd::cancelled || result.end == FlowEnd::stopped)
        throw core::RunError(result.reason + "; " + options->folder + " has the state before");
    return apps::exit_done;
}

}  // namespace

}  // namespace dsc::flow

int main(int argc, char** argv) {
    return dsc::apps::run_main("flow", [&] { return dsc::flow::run(argc, argv); });
}
