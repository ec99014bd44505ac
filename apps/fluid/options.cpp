// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/options.h"

#include <vector>

#include "apps/common/number_list.h"
#include "core/errors.h"
#include "io/atomic_file.h"

namespace dsc::fluid_app {

namespace {

/// Values that replace those of the scene.
struct Overrides {
    std::optional<double> density, tension, viscosity, wetting, edge_length, velocity, until;
    std::optional<std::string> gravity;
};

void override_scene(const Overrides& given, Scene& scene) {
    if (given.density) scene.density = *given.density;
    if (given.tension) scene.tension = *given.tension;
    if (given.viscosity) scene.viscosity = *given.viscosity;
    if (given.wetting) scene.wetting = *given.wetting;
    if (given.edge_length) scene.edge_length = *given.edge_length;
    if (given.until) scene.until = *given.until;
    if (given.gravity) scene.gravity = apps::parsed_point<3>("--gravity", *given.gravity);
    if (!given.velocity) return;
    for (Ball& ball : scene.balls) {
        if (ball.velocity.norm() == 0) throw core::UsageError("--velocity: the bodies of this scene are at rest");
        ball.velocity *= *given.velocity / ball.velocity.norm();
    }
}

std::optional<double> parsed_step(const std::string& text) {
    if (text == "auto") return std::nullopt;
    const std::vector<double> numbers = apps::parsed_numbers("--dt", text);
    if (numbers.size() != 1 || !(numbers[0] > 0))
        throw core::UsageError("--dt: \"" + text + "\" is neither auto nor a positive time");
    return numbers[0];
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv) {
    Options options;
    Overrides overrides;
    std::optional<std::string> file, name, dt;
    int steps = 0;
    bool keeps_transfer = false;
    apps::CommandLine line("fluid",
                           "Incompressible flow with a free surface and surface tension, its tetrahedra those of a "
                           "deformable simplicial complex.",
                           "fluid --scene collide -o run",
                           {.output = "folder for series.pvd, surface_0000.obj, final.mesh, report.json, index.html, "
                                      "checkpoint",
                            .output_is_folder = true});
    line.heading("Scene");
    line.input_file("SCENE", file, "a scene as JSON (docs/fluid.md); not needed with --scene or --resume");
    line.choice("--scene", name, scene_names(), "a scene that has a name");
    line.number("--edge-length", overrides.edge_length, "of the surface", {.above = 0});
    line.number("--density", overrides.density, "of the fluid", {.above = 0});
    line.number("--tension", overrides.tension, "of the surface", {.at_least = 0});
    line.number("--viscosity", overrides.viscosity, "dynamic", {.at_least = 0});
    line.number("--wetting", overrides.wetting, "alpha_1 - alpha_2 of the walls", {.at_least = -1, .at_most = 1});
    line.number("--velocity", overrides.velocity, "speed of the bodies that are not at rest", {.at_least = 0});
    line.text("--gravity", overrides.gravity, "acceleration x,y,z");
    line.heading("Run");
    line.number("--until", overrides.until, "time at the end", {.above = 0});
    line.integer("--steps", steps, "number of steps at most (0: no limit)", {.at_least = 0});
    line.text("--dt", dt, "length of a step, or auto: as long as the limits allow (default auto)");
    line.number("--capillary-share", options.capillary_share, "longest step of auto, in capillary limits (default 0.5)",
                {.above = 0});
    line.flag("--second-order", options.has_second_order_tension,
              "surface energy to second order, for steps beyond the capillary limit");
    line.number("--stabilization", options.stabilization, "beta of the pressure stabilization (default 0.1)",
                {.at_least = 0});
    line.number("--compensation", options.compensation, "tau of the volume compensation (default 0.5)",
                {.at_least = 0, .at_most = 1});
    line.flag("--keep-transfer", keeps_transfer, "don't give back the momentum that mesh improvement changes");
    line.heading("Output");
    line.integer("--snapshots", options.snapshots, "of the surface in series.pvd, OBJ files and index.html",
                 {.at_least = 0, .at_most = 10000});
    line.integer("--checkpoint", options.checkpoint_interval,
                 "steps from one checkpoint in the folder to the next, 0 for none; the steps depend on it a little, "
                 "since mesh and random numbers begin anew there",
                 {.at_least = 0});
    line.flag("--resume", options.is_resumed,
              "go on from the checkpoint in the folder, with the options of that run: fluid --resume -o DIR");
    if (!line.parse(argc, argv)) return std::nullopt;
    options.common = line.common();
    options.given = line.given();
    if (!options.common.output) throw core::UsageError("-o DIR is needed");
    options.folder = *options.common.output;
    if (options.is_resumed) return options;
    if (file && name) throw core::UsageError("SCENE and --scene can't both be given");
    if (!file && !name) throw core::UsageError("a scene is needed, as a file or by --scene; see fluid --help");
    if (options.capillary_share > 1 && !options.has_second_order_tension)
        throw core::UsageError("--capillary-share above 1 is stable with --second-order only");
    options.scene = name ? named_scene(*name) : scene_from_json(io::Json::parse(io::read_file(*file), *file), *file);
    override_scene(overrides, options.scene);
    require_consistent(options.scene, file.value_or("scene " + options.scene.name));
    options.conserves_momentum = !keeps_transfer;
    options.run.until = options.scene.until;
    if (dt) options.run.dt = parsed_step(*dt);
    if (steps > 0) options.run.steps = steps;
    return options;
}

}  // namespace dsc::fluid_app
