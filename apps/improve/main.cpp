// SPDX-License-Identifier: GPL-3.0-or-later
// The program improve: see `improve --help` and docs/improve.md.
#include <fmt/core.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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
    std::optional<geometry::TetData> input;  ///< as it was read, when vertices keep their numbers
    io::TetMeshDialect dialect;              ///< of the input, for the output
};

std::unique_ptr<dsc3d::Mesh> read_mesh(const Options& options, Meshes& meshes) {
    io::TetMeshFile file = io::read_tet_mesh(options.input);
    meshes.dialect = file.dialect;
    if (options.merges_regions) file.data.labels.clear();
    auto mesh = std::make_unique<dsc3d::Mesh>(file.data, options.input);
    if (options.parameters.keeps_vertices) meshes.input = std::move(file.data);
    return mesh;
}

/// The engine drops vertices that no tetrahedron uses: puts them back in their places, so that all numbers are those of
/// the input. The used vertices are the same ones, in the same order.
geometry::TetData with_unused_vertices(const geometry::TetData& improved, const geometry::TetData& input) {
    std::vector<std::uint8_t> is_used(input.vertices.size(), 0);
    for (const auto& tet : input.tets)
        for (const std::uint32_t v : tet) is_used[v] = 1;
    geometry::TetData result = improved;
    result.vertices = input.vertices;
    std::vector<std::uint32_t> number;
    number.reserve(improved.vertices.size());
    for (std::uint32_t v = 0; v < is_used.size(); ++v) {
        if (is_used[v] == 0) continue;
        result.vertices[v] = improved.vertices[number.size()];
        number.push_back(v);
    }
    for (auto& tet : result.tets)
        for (std::uint32_t& v : tet) v = number[v];
    return result;
}

void write_mesh(const std::string& path, const Meshes& meshes) {
    if (meshes.input) {
        io::write_tet_mesh(path, with_unused_vertices(*meshes.after, *meshes.input), meshes.dialect);
    } else {
        io::write_tet_mesh(path, *meshes.after, meshes.dialect);
    }
}

Improvement work(const Options& options, core::Observer& observer, Meshes& meshes) {
    const core::Stopwatch watch;
    Improvement result{.input = options.input, .output = options.common.output, .parameters = options.parameters};
    const geometry::QualityMeasure measure = options.parameters.measure;
    observer.progress("reading " + options.input, -1, "");
    std::unique_ptr<dsc3d::Mesh> mesh = read_mesh(options, meshes);
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
    if (options.common.output) write_mesh(*options.common.output, meshes);
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
