// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/options.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <vector>

#include "apps/common/number_list.h"
#include "apps/flow/names.h"
#include "apps/flow/passes.h"
#include "core/errors.h"
#include "io/number.h"

namespace dsc::flow {

namespace {

/// What stood on the command line and is not a number yet.
struct Texts {
    std::string shape;
    std::string motion = "rotate";
    std::string topology = "preserved";
    std::optional<std::string> centre, size, domain, axis, about, direction, gradient, velocity, array;
};

void parse_size(const std::string& text, ShapeOptions& options) {
    const std::vector<double> numbers = apps::parsed_numbers("--size", text);
    const bool is_cube = numbers.size() == 1;
    if (!is_cube && numbers.size() != 3) throw core::UsageError("--size: \"" + text + "\" is not one or three lengths");
    options.size = is_cube ? Point3::Constant(numbers[0]) : Point3(numbers[0], numbers[1], numbers[2]);
    if (options.size->minCoeff() <= 0) throw core::UsageError("--size: lengths have to be positive");
    if (options.shape == Shape::slotted_cube && !is_cube)
        throw core::UsageError("--size: a slotted cube has one length");
}

constexpr std::string_view sphere_prefix = "sphere:";

bool is_surface_file(const std::string& text) {
    static const std::set<std::string> extensions = {".off", ".obj", ".ply", ".stl"};
    return extensions.contains(std::filesystem::path(text).extension().string());
}

SphericalDomain parsed_sphere(const std::string& text) {
    const std::vector<double> n = apps::parsed_numbers("--domain", text.substr(sphere_prefix.size()));
    if ((n.size() != 1 && n.size() != 4) || !(n.back() > 0))
        throw core::UsageError("--domain: \"" + text + "\" is not sphere:radius or sphere:x,y,z,radius");
    return {n.size() == 4 ? Point3(n[0], n[1], n[2]) : Point3(0.5, 0.5, 0.5), n.back()};
}

Eigen::AlignedBox3d parsed_domain(const std::string& text) {
    const std::vector<double> n = apps::parsed_numbers("--domain", text);
    if (n.size() != 6 || !(n[0] < n[3] && n[1] < n[4] && n[2] < n[5]))
        throw core::UsageError("--domain: \"" + text +
                               "\" is not x0,y0,z0,x1,y1,z1 with lower corner first, sphere:x,y,z,radius or a "
                               "surface (.off, .obj, .ply, .stl)");
    return {Point3(n[0], n[1], n[2]), Point3(n[3], n[4], n[5])};
}

void parse_texts(const Texts& texts, Options& options) {
    const auto is_name = [&](const auto& entry) { return entry.name == texts.shape; };
    const auto shape = std::ranges::find_if(shape_names, is_name);
    options.shape.shape = shape == shape_names.end() ? Shape::file : shape->value;
    if (options.shape.shape == Shape::file) {
        options.shape.path = texts.shape;
        if (texts.shape.find('.') == std::string::npos) {
            std::string list;
            for (const std::string& name : all_names(shape_names)) list += name + ", ";
            throw core::UsageError("\"" + texts.shape + "\" is neither a shape (" + list.substr(0, list.size() - 2) +
                                   ") nor a file with an extension");
        }
    }
    if (texts.centre) options.shape.centre = apps::parsed_point<3>("--center", *texts.centre);
    if (texts.size) parse_size(*texts.size, options.shape);
    if (texts.domain && texts.domain->starts_with(sphere_prefix)) {
        options.shape.sphere = parsed_sphere(*texts.domain);
    } else if (texts.domain && is_surface_file(*texts.domain)) {
        options.shape.container = *texts.domain;
    } else if (texts.domain) {
        options.shape.domain = parsed_domain(*texts.domain);
    }

    MotionOptions& motion = options.motion;
    motion.motion = value_of(motion_names, texts.motion);
    if (texts.axis) motion.axis = apps::parsed_point<3>("--axis", *texts.axis);
    if (motion.axis.norm() == 0) throw core::UsageError("--axis: must not be zero");
    if (texts.about) motion.about = apps::parsed_point<3>("--about", *texts.about);
    if (texts.direction) motion.direction = apps::parsed_point<3>("--direction", *texts.direction);
    if (texts.gradient) motion.gradient = apps::parsed_point<3>("--gradient", *texts.gradient);
    motion.seed = static_cast<std::uint64_t>(options.common.seed);
    motion.array = texts.array.value_or("");
    if (motion.motion == Motion::expression) {
        motion.expressions = texts.velocity;
    } else if (motion.motion == Motion::grid) {
        motion.path = texts.velocity.value_or("");
    } else if (texts.velocity) {
        motion.velocity = apps::parsed_point<3>("--velocity", *texts.velocity);
    }
    options.topology = value_of(topology_names, texts.topology);
}

// An option that the shape or motion has no use for is a mistake that would go unseen.
void check_uses(const apps::CommandLine& line, const Options& options) {
    const auto require_use = [&](const std::string& option, const std::set<std::string>& users,
                                 const std::string& user) {
        if (!line.is_given(option) || users.contains(user)) return;
        std::string list;
        for (const std::string& name : users) list += (list.empty() ? "" : ", ") + name;
        throw core::UsageError(option + ": goes with " + list + " only");
    };
    const std::string shape = options.shape.shape == Shape::file ? "file" : name_of(shape_names, options.shape.shape);
    require_use("--center", {"sphere", "box", "torus", "dumbbell", "two-spheres", "slotted-cube", "labelled-block"},
                shape);
    require_use("--radius", {"sphere", "two-spheres", "torus", "dumbbell"}, shape);
    require_use("--minor-radius", {"torus", "dumbbell"}, shape);
    require_use("--spread", {"dumbbell"}, shape);
    require_use("--gap", {"two-spheres"}, shape);
    require_use("--size", {"box", "labelled-block", "slotted-cube"}, shape);
    require_use("--slot-width", {"slotted-cube"}, shape);
    require_use("--slot-depth", {"slotted-cube"}, shape);
    require_use("--feature-angle", {"file"}, shape);
    if (line.is_given("--feature-angle") && !line.is_given("--edge-length"))
        throw core::UsageError("--feature-angle goes with --edge-length: without it the surface is kept");
    const std::string motion = name_of(motion_names, options.motion.motion);
    require_use("--axis", {"rotate"}, motion);
    require_use("--about", {"rotate", "shear"}, motion);
    require_use("--angle", {"rotate"}, motion);
    require_use("--distance", {"offset"}, motion);
    require_use("--period", {"enright", "vortex"}, motion);
    require_use("--speed", {"curl-noise"}, motion);
    require_use("--frequency", {"curl-noise"}, motion);
    require_use("--direction", {"shear"}, motion);
    require_use("--gradient", {"shear"}, motion);
    require_use("--velocity", {"translate", "expression", "grid"}, motion);
    require_use("--array", {"grid"}, motion);
    if (options.motion.motion == Motion::offset && !options.motion.distance)
        throw core::UsageError("--motion offset needs --distance");
    if (options.motion.motion == Motion::translate && !options.motion.velocity)
        throw core::UsageError("--motion translate needs --velocity x,y,z");
    if (options.motion.motion == Motion::expression && !options.motion.expressions)
        throw core::UsageError("--motion expression needs --velocity \"(-y, x, 0)\"");
    if (options.motion.motion == Motion::grid && options.motion.path.empty())
        throw core::UsageError("--motion grid needs --velocity FILE.vti");
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv) {
    Options options;
    ShapeOptions& shape = options.shape;
    MotionOptions& motion = options.motion;
    Texts texts;
    int steps = 0;
    apps::CommandLine line(
        "flow",
        "Moves an interface through a tetrahedral mesh, as a deformable simplicial complex. SHAPE: sphere, box, torus, "
        "dumbbell, two-spheres, slotted-cube, labelled-block; a closed surface (.off, .obj, .ply, .stl); or a labelled "
        "tetrahedral mesh (.mesh, .msh, .node, .vtu, .vtk). With --dimension 2, in the plane: disc, two-discs, ring, "
        "dumbbell, slotted-disc, polygon, box, labelled-block; polygons (.svg, .csv, .json); or a labelled planar mesh "
        "(.mesh). Points have two coordinates then.",
        "flow slotted-cube --motion rotate --angle 360 --steps 50 -o turned",
        {.output = "folder for final.obj, final.mesh, series.pvd, report.json, index.html, checkpoint",
         .output_is_folder = true});
    std::optional<std::string> shape_text;
    line.input_file("SHAPE", shape_text, "what moves: a name, or a file (not needed with --resume)");
    line.heading("Shape");
    line.text("--center", texts.centre, "x,y,z (default 0.5,0.5,0.5)");
    line.number("--radius", shape.radius, "of sphere, balls or ring (default 0.3; two-spheres 0.15)", {.above = 0});
    line.number("--minor-radius", shape.minor_radius, "of the tube of a torus, the neck of a dumbbell (default 0.1)",
                {.above = 0});
    line.number("--spread", shape.spread, "distance of the balls' centres of a dumbbell (default 1)", {.above = 0});
    line.number("--gap", shape.gap, "between two spheres (default 0.01)", {.above = 0});
    line.text("--size", texts.size, "side, or x,y,z (default: slotted-cube, labelled-block 0.4, box 1)");
    line.number("--slot-width", shape.slot_width, "of a slotted cube (default a quarter of its side)", {.above = 0});
    line.number("--slot-depth", shape.slot_depth, "of a slotted cube (default half of its side)", {.above = 0});
    line.number("--edge-length", shape.edge_length,
                "of the triangles; a surface from a file is remeshed to it, and kept as it is without", {.above = 0});
    line.number("--feature-angle", shape.feature_angle,
                "edges bent by more than this stay sharp when a surface is remeshed, in degrees (default 40)",
                {.above = 0, .at_most = 180});
    line.number(
        "--growth", shape.growth,
        "of the edges of the tetrahedra around the surface, per distance from it; less than 0.6 is coarsened to "
        "that at the start (default 1)",
        {.at_least = 0, .at_most = 2});
    line.text("--domain", texts.domain,
              "x0,y0,z0,x1,y1,z1 (default: the unit box, or twice the size of what has no room there); in space also "
              "sphere:x,y,z,radius, sphere:radius around 0.5,0.5,0.5, or a closed surface (.off, .obj, .ply, .stl), "
              "whose triangles are kept");
    planar::Texts planar_texts;
    planar::add_options(line, planar_texts);
    line.heading("Motion");
    line.choice("--motion", texts.motion, all_names(motion_names), "what moves the interface");
    line.text("--axis", texts.axis, "of rotation, x,y,z (default 0,0,1)");
    line.text("--about", texts.about, "point that stays in rotation and shear, x,y,z (default: centre of the domain)");
    line.number("--angle", motion.angle, "of rotation in all, in degrees");
    line.number("--distance", motion.distance, "of the offset in all, negative inwards");
    line.number("--period", motion.period, "of enright and vortex", {.above = 0});
    line.number("--speed", motion.speed, "of curl-noise, the largest", {.above = 0});
    line.number("--frequency", motion.frequency, "of curl-noise, in wave lengths across the domain, at most",
                {.at_least = 1, .at_most = 20});
    line.text("--direction", texts.direction, "of shear: the velocity at a distance of 1, x,y,z (default 1,0,0)");
    line.text("--gradient", texts.gradient, "of shear: where it grows to, perpendicular to it (default 0,1,0)");
    line.text("--velocity", texts.velocity,
              "x,y,z of translate; \"(-y, x, 0)\" in x, y, z, t of expression; a file (.vti) of grid");
    line.text("--array", texts.array, "of the file of grid, when it has several");
    line.heading("Time");
    line.number("--dt", options.time.dt, "of a step", {.above = 0});
    line.number("--until", options.time.until, "time at the end (default 1; enright and vortex: their period)",
                {.above = 0});
    line.integer("--steps", steps, "number of steps (0: from --dt and --until, or 50)", {.at_least = 0});
    line.heading("Deformation");
    line.choice("--topology", texts.topology, all_names(topology_names),
                "what may happen where the interface meets itself");
    line.integer("--dimension", options.dimension, "2 or 3", {.at_least = 2, .at_most = 3});
    line.text(
        "--sizing", options.sizing,
        "edge lengths: uniform, curvature, thickness, or an expression in x, y, z, t: lengths up to --edge-length");
    std::string pass_list;
    for (const std::string& name : pass_names()) pass_list += (pass_list.empty() ? "" : ", ") + name;
    std::optional<std::string> without;
    line.text("--without", without, "passes to be switched off, separated by commas: " + pass_list);
    line.heading("Output");
    line.integer("--snapshots", options.snapshots, "of the interface in series.pvd and index.html, evenly spaced",
                 {.at_least = 0, .at_most = 10000});
    line.integer("--checkpoint", options.checkpoint_interval,
                 "steps from one checkpoint in the folder to the next, 0 for none; the steps depend on it a little, "
                 "since mesh and random numbers begin anew there",
                 {.at_least = 0});
    line.flag("--resume", options.is_resumed,
              "go on from the checkpoint in the folder, with the options of that run: flow --resume -o DIR");
    if (!line.parse(argc, argv)) return std::nullopt;

    options.common = line.common();
    options.given = line.given();
    if (!options.common.output) throw core::UsageError("-o DIR is needed");
    options.folder = *options.common.output;
    if (options.dimension == 2) {
        if (options.sizing) throw core::UsageError("--sizing is there in three dimensions only");
        if (without) throw core::UsageError("--without is there in three dimensions only");
    }
    if (without) {
        options.without = *without;
        dsc3d::DeformParameters trial;
        switch_off(options.without, trial);
    }
    if (options.is_resumed) return options;
    if (!shape_text) throw core::UsageError("SHAPE is needed; see flow --help");
    texts.shape = *shape_text;
    if (steps > 0) options.time.steps = steps;
    if (options.time.dt && options.time.until && options.time.steps)
        throw core::UsageError("only two of --dt, --until, --steps can be given: the third one follows");
    if (options.dimension == 2) {
        options.topology = value_of(topology_names, texts.topology);
        options.planar = planar::parsed_options(line, options, planar_texts);
        return options;
    }
    if (planar::is_any_given(line)) throw core::UsageError("--sides and --torus go with --dimension 2 only");
    parse_texts(texts, options);
    check_uses(line, options);
    return options;
}

}  // namespace dsc::flow
