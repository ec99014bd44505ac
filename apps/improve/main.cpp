// SPDX-License-Identifier: GPL-3.0-or-later
// The program improve: see `improve --help` and docs/improve.md.
#include <fmt/core.h>

#include <memory>
#include <optional>

#include "apps/common/progress.h"
#include "apps/common/run_main.h"
#include "apps/improve/histogram_picture.h"
#include "apps/improve/html_page.h"
#include "apps/improve/options.h"
#include "apps/improve/report.h"
#include "core/errors.h"
#include "core/stopwatch.h"
#include "dsc3d/mesh.h"
#include "io/atomic_file.h"
#include "io/tet_mesh.h"

namespace dsc::improve {

namespace {

/// What is read and made; a mesh is kept only as long as it is needed: two million tetrahedra take 50 MB each time.
struct Meshes {
    std::optional<geometry::TetData> before, after;
    io::TetMeshDialect dialect;  ///< of the input, for the output
};

std::unique_ptr<dsc3d::Mesh> read_mesh(const Options& options, io::TetMeshDialect& dialect) {
    io::TetMeshFile file = io::read_tet_mesh(options.input);
    dialect = file.dialect;
    if (options.merges_regions) file.data.labels.clear();
    return std::make_unique<dsc3d::Mesh>(file.data, options.input);
}

Improvement work(const Options& options, core::Observer& observer, Meshes& meshes) {
    const core::Stopwatch watch;
    Improvement result{.input = options.input, .output = options.common.output, .parameters = options.parameters};
    const geometry::QualityMeasure measure = options.parameters.measure;
    observer.progress("reading " + options.input, -1, "");
    std::unique_ptr<dsc3d::Mesh> mesh = read_mesh(options, meshes.dialect);
    meshes.before = mesh->data();
    result.read_seconds = watch.seconds();
    result.before = mesh_statistics(*meshes.before, measure, options.parameters.threads);
    if (!options.html) meshes.before.reset();
    if (!options.is_report_only) {
        result.run = dsc3d::improve(*mesh, options.parameters, observer);
        meshes.after = mesh->data();
        mesh.reset();
        result.after = mesh_statistics(*meshes.after, measure, options.parameters.threads);
    }
    result.total_seconds = watch.seconds();
    return result;
}

void write_results(const Options& options, const Improvement& result, const Meshes& meshes) {
    if (options.common.output) io::write_tet_mesh(*options.common.output, *meshes.after, meshes.dialect);
    if (options.svg) {
        std::vector<AngleHistogram> histograms{{"before", result.before}};
        if (result.after) histograms.push_back({"after", *result.after});
        io::write_file(*options.svg, histogram_picture(histograms));
    }
    if (options.html) {
        const geometry::TetData* after = meshes.after ? &*meshes.after : nullptr;
        io::write_html_page(*options.html,
                            html_page(result, *meshes.before, after, {.threads = options.parameters.threads}));
    }
    if (options.common.json) io::write_file(*options.common.json, report_json(result).dump(1) + "\n");
}

int run(int argc, const char* const* argv) {
    const std::optional<Options> options = parse_options(argc, argv);
    if (!options) return apps::exit_done;
    apps::ProgressObserver observer(options->common.progress);
    Meshes meshes;
    const Improvement result = work(*options, observer, meshes);
    write_results(*options, result, meshes);
    observer.clear();
    if (!options->common.quiet || !options->has_output()) fmt::print("{}", report_text(result));
    if (result.run && result.run->end == dsc3d::ImproveEnd::cancelled)
        throw core::RunError("stopped by the user" +
                             (result.output ? "; " + *result.output + " has the mesh so far" : ""));
    if (result.run && !result.output && !options->common.quiet)
        fmt::print("the mesh was not written: -o FILE does that\n");
    return apps::exit_done;
}

}  // namespace

}  // namespace dsc::improve

int main(int argc, char** argv) {
    return dsc::apps::run_main("improve", [&] { return dsc::improve::run(argc, argv); });
}
