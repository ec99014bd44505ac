// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the program flow: what is asked for, checked.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "apps/common/command_line.h"
#include "apps/flow/planar/options.h"
#include "geometry/predicates.h"
#include "io/json.h"
#include "motion/topology.h"

namespace dsc::flow {

using geometry::Point3;

enum class Shape : std::uint8_t { sphere, box, torus, dumbbell, two_spheres, slotted_cube, labelled_block, file };

struct SphericalDomain {
    Point3 centre;
    double radius;
};

/// Sizes that were not given follow from the shape: see initial_mesh.h.
struct ShapeOptions {
    Shape shape = Shape::sphere;
    std::string path;  ///< of a file
    Point3 centre = Point3(0.5, 0.5, 0.5);
    std::optional<double> radius;        ///< sphere, two-spheres, torus (of the ring), dumbbell (of the balls)
    std::optional<double> minor_radius;  ///< torus (of the tube), dumbbell (of the neck)
    std::optional<double> spread;        ///< dumbbell: distance of the centres of the balls
    std::optional<double> gap;           ///< two-spheres
    std::optional<Point3> size;          ///< box, labelled-block; slotted-cube (all three the same)
    std::optional<double> slot_width, slot_depth;
    std::optional<double> edge_length;
    std::optional<double> growth;         ///< of the tetrahedra to begin with, off the interface, per distance
    std::optional<double> feature_angle;  ///< of a surface from a file that is remeshed [degree]
    std::optional<Eigen::AlignedBox3d> domain;
    std::optional<SphericalDomain> sphere;  ///< instead of a box
    std::string container;                  ///< instead of a box: the file of a closed surface; empty: none
};

enum class Motion : std::uint8_t {
    rotate,
    curvature,
    offset,
    enright,
    vortex,
    curl_noise,
    shear,
    translate,
    expression,
    grid
};

struct MotionOptions {
    Motion motion = Motion::rotate;
    Point3 axis = Point3(0, 0, 1);           ///< rotate: not zero
    std::optional<Point3> about;             ///< rotate, shear: a point that stays; absent: the centre of the domain
    double angle = 360;                      ///< rotate: in all [degree]
    std::optional<double> distance;          ///< offset: in all; negative inwards
    double period = 3;                       ///< enright, vortex: time after which the flow is back at its start
    double speed = 1;                        ///< curl-noise: the largest
    double frequency = 3;                    ///< curl-noise: wave lengths across the domain, at most
    std::uint64_t seed = 1;                  ///< curl-noise
    Point3 direction = Point3(1, 0, 0);      ///< shear: the velocity at a distance of 1 along the gradient
    Point3 gradient = Point3(0, 1, 0);       ///< shear: perpendicular to it
    std::optional<Point3> velocity;          ///< translate
    std::optional<std::string> expressions;  ///< expression: "(-y, x, 0)" in x, y, z and t
    std::string path;                        ///< grid: the VTI file
    std::string array;                       ///< grid: its array; empty: the only one that is a velocity
};

struct TimeOptions {
    std::optional<double> dt;     ///< of a step
    std::optional<double> until;  ///< end
    std::optional<int> steps;     ///< number
};

struct Options {
    ShapeOptions shape;
    MotionOptions motion;
    TimeOptions time;
    motion::TopologyPolicy topology = motion::TopologyPolicy::preserved;
    int dimension = 3;
    std::optional<planar::Options> planar;  ///< dimension 2: then shape and motion are those of its own
    std::optional<std::string> sizing;
    std::string without;  ///< passes that are switched off, separated by commas
    int snapshots = 20;
    int checkpoint_interval = 25;  ///< steps; 0: no checkpoints
    bool is_resumed = false;
    std::string folder;
    apps::CommonOptions common;
    io::Json given;  ///< the options on the command line, for the report
};

/// Nothing when --help or --version was asked for. With --resume only what is common to all programs, `folder` and
/// `given` are filled: the rest is in the checkpoint. Throws core::UsageError and core::InputError.
std::optional<Options> parse_options(int argc, const char* const* argv);

}  // namespace dsc::flow
