// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/options.h"

#include "core/errors.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"

namespace dsc::reconstruct {

std::optional<Options> parse_options(int argc, const char* const* argv) {
    Options options;
    ReconstructParameters& parameters = options.parameters;
    apps::CommandLine line("reconstruct",
                           "Makes a closed surface, and the tetrahedra inside it, from points without normals. Reads "
                           ".xyz, .txt, .pts, .asc, .csv, and the vertices of .ply, .off and .obj; writes .obj, .off, "
                           ".ply and .stl.",
                           "reconstruct scan.xyz -o scan.obj --tets scan.vtu --html scan.html",
                           {.output = "write the surface to this file, in the format of its extension"});
    line.input_file("POINTS", options.input, "the cloud");
    line.heading("What is known of the cloud");
    line.number("--detail", parameters.detail,
                "length of the edges where the surface is not flat, instead of one that follows the spacing of the "
                "points, in their unit",
                {.above = 0});
    line.number("--noise", parameters.noise,
                "standard deviation of the points off the surface, instead of an estimate, in their unit",
                {.at_least = 0});
    std::string genus = "free";
    line.choice("--genus", genus, {"free", "0"},
                "free: whatever the points ask for; 0: one surface without handles, as a sphere that shrinks onto the "
                "points leaves it, with films across tunnels and threads between parts");
    line.heading("Output");
    line.output_file("--tets", options.tets,
                     "write the tetrahedra inside to this file: .vtu, .mesh, .msh, .node, .vtk");
    line.number("--min-angle", parameters.min_angle, "least dihedral angle that the tetrahedra should have, in degrees",
                {.above = 0, .at_most = 40});
    line.output_file("--html", options.html, "write a page with cloud, surface and stages to this file");
    line.output_folder("--snapshots", options.snapshots,
                       "write the surface at the end of each stage to this folder, as series.pvd for ParaView");
    if (!line.parse(argc, argv)) return std::nullopt;

    options.common = line.common();
    options.given = line.given();
    parameters.threads = options.common.threads;
    parameters.keeps_genus_zero = genus == "0";
    parameters.makes_tets = options.tets.has_value();
    if (line.is_given("--min-angle") && !options.tets) throw core::UsageError("--min-angle goes with --tets only");
    if (options.common.output) io::require_writable_surface_mesh(*options.common.output);
    if (options.tets) io::require_writable_tet_mesh(*options.tets);
    return options;
}

}  // namespace dsc::reconstruct
