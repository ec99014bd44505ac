// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/options.h"

#include "apps/improve/names.h"
#include "core/errors.h"
#include "io/tet_mesh.h"

namespace dsc::improve {

std::optional<Options> parse_options(int argc, const char* const* argv) {
    Options options;
    dsc3d::ImproveParameters& parameters = options.parameters;
    std::string measure = name_of(measure_names, parameters.measure);
    std::string schedule = name_of(schedule_names, parameters.schedule);
    bool has_no_mfrt = false, has_no_thinning = false, keeps_boundary = false;

    apps::CommandLine line(
        "improve",
        "Improves a tetrahedral mesh: larger angles, no new vertices, the boundary stays where it "
        "is. Reads and writes TetGen .node/.ele, MEDIT .mesh, Gmsh .msh, .vtu and legacy .vtk.",
        "improve bracket.mesh -o better.mesh --measure sine --html bracket.html",
        {.output = "write the improved mesh to this file, in the format of its extension", .may_replace_input = true});
    line.input_file("IN", options.input, "the mesh");
    line.heading("What is better");
    line.choice("--measure", measure, all_names(measure_names),
                "quality of a tetrahedron, whose least value is raised");
    line.number("--target-angle", parameters.target_angle,
                "stop when all dihedral angles lie between this one and 180 minus it, in degrees",
                {.above = 0, .at_most = 70.5});
    line.number("--time-limit", parameters.time_limit, "stop after this time, in seconds", {.above = 0});
    line.flag("--report", options.is_report_only, "judge the mesh and leave it as it is");
    line.heading("What may be done");
    line.choice("--schedule", schedule, all_names(schedule_names),
                "thesis: until no single operation helps; best: go on from there with compound ones");
    line.flag("--no-mfrt", has_no_mfrt, "leave out multi-face retriangulation");
    line.flag("--no-thinning", has_no_thinning, "leave out the thinning pass, which collapses edges");
    line.flag("--keep-vertices", parameters.keeps_vertices, "neither remove vertices nor take them elsewhere");
    line.heading("Boundary, and interfaces between regions");
    line.flag("--no-boundary", keeps_boundary, "leave its triangles as they are");
    line.flag("--merge-regions", options.merges_regions, "forget the regions: all are one, without interfaces");
    line.number("--feature-angle", parameters.feature_angle, "edges bent by more than this are ridges, in degrees",
                {.above = 0, .at_most = 180});
    line.number("--max-boundary-change", parameters.max_boundary_change,
                "largest distance it may move, in diagonals of the mesh", {.at_least = 0, .at_most = 1e-2});
    line.heading("Output");
    line.output_file("--html", options.html, "page with the mesh before and after, to be turned and cut open");
    line.output_file("--svg", options.svg, "histograms of all dihedral angles, before and after");
    if (!line.parse(argc, argv)) return std::nullopt;

    options.common = line.common();
    if (options.is_report_only && options.common.output)
        throw core::UsageError("--report writes no mesh: leave -o or --report out");
    if (options.common.output) io::require_writable_tet_mesh(*options.common.output);
    parameters.measure = value_of(measure_names, measure);
    parameters.schedule = value_of(schedule_names, schedule);
    parameters.uses_multi_face_retriangulation = !has_no_mfrt;
    parameters.uses_thinning = !has_no_thinning;
    parameters.changes_boundary = !keeps_boundary;
    parameters.seed = static_cast<std::uint64_t>(options.common.seed);
    parameters.threads = options.common.threads;
    return options;
}

}  // namespace dsc::improve
