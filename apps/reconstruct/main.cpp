// SPDX-License-Identifier: GPL-3.0-or-later
// The program reconstruct: see `reconstruct --help` and docs/reconstruct.md.
#include <fmt/core.h>

#include <filesystem>

#include "apps/common/progress.h"
#include "apps/common/run_main.h"
#include "apps/reconstruct/options.h"
#include "apps/reconstruct/report.h"
#include "apps/reconstruct/stages.h"
#include "core/stopwatch.h"
#include "io/atomic_file.h"
#include "io/points.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"

namespace dsc::reconstruct {

namespace {

void write_results(const Options& options, const geometry::PointData& cloud, const Reconstruction& result,
                   const Stages& stages) {
    if (options.common.output)
        io::write_surface_mesh(*options.common.output, result.surface,
                               {.vertex_columns = {{"distance", result.vertex_distance}},
                                .face_columns = {{"invented", result.is_invented}}});
    if (options.tets) io::write_tet_mesh(*options.tets, result.tets);
    if (options.html)
        io::write_html_page(*options.html,
                            html_page(result, cloud, stages, std::filesystem::path(options.input).filename().string()));
    if (options.common.json) io::write_file(*options.common.json, report_json(result, options.given).dump(1) + "\n");
}

int run(int argc, const char* const* argv) {
    const std::optional<Options> options = parse_options(argc, argv);
    if (!options) return apps::exit_done;
    apps::ProgressObserver observer(options->common.progress);
    observer.progress("reading " + options->input, -1, "");
    const core::Stopwatch watch;
    const geometry::PointData cloud = io::read_points(options->input);
    const double read_seconds = watch.seconds();
    Stages stages(options->snapshots);
    StageWatcher watcher;
    if (options->snapshots || options->html)
        watcher = [&](const std::string& stage, const geometry::SurfaceData& surface) { stages.add(stage, surface); };
    Reconstruction result = reconstruct(cloud, options->parameters, options->input, observer, watcher);
    result.phases.insert(result.phases.begin(), {"read", read_seconds});
    write_results(*options, cloud, result, stages);
    observer.clear();
    if (!options->common.quiet) fmt::print("{}", report_text(result));
    if (!options->common.output && !options->common.quiet)
        fmt::print("the surface was not written: -o FILE does that\n");
    return apps::exit_done;
}

}  // namespace

}  // namespace dsc::reconstruct

int main(int argc, char** argv) {
    return dsc::apps::run_main("reconstruct", [&] { return dsc::reconstruct::run(argc, argv); });
}
