// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the program flow in the plane (--dimension 2): what its options mean there, checked.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "apps/common/command_line.h"
#include "geometry/predicates.h"

namespace dsc::flow {
struct Options;
}

namespace dsc::flow::planar {

using geometry::Point2;

enum class Shape : std::uint8_t { disc, two_discs, ring, dumbbell, slotted_disc, polygon, box, labelled_block, file };

/// Sizes that were not given follow from the shape: see initial_complex.h.
struct ShapeOptions {
    Shape shape = Shape::disc;
    std::string path;  ///< of a file
    Point2 centre = Point2(0.5, 0.5);
    std::optional<double> radius;        ///< disc, two-discs, slotted-disc, polygon, ring (middle), dumbbell (discs)
    std::optional<double> minor_radius;  ///< half the width of a ring, of the neck of a dumbbell
    std::optional<double> spread;        ///< dumbbell: distance of the centres of the discs
    std::optional<double> gap;           ///< two-discs
    std::optional<Point2> size;          ///< box, labelled-block
    std::optional<double> slot_width, slot_depth;
    int sides = 6;  ///< polygon
    std::optional<double> edge_length;
    std::optional<Eigen::AlignedBox2d> domain;
    bool is_torus = false;  ///< the domain repeats itself in both directions
};

enum class Motion : std::uint8_t { rotate, curvature, offset, vortex, curl_noise, shear, translate, expression, grid };

struct MotionOptions {
    Motion motion = Motion::rotate;
    std::optional<Point2> about;  ///< rotate, shear: stays; absent: the centre of the domain
    double angle = 360;           ///< rotate: in all, counterclockwise [degree]
    double distance = 0;          ///< offset: in all; negative inwards
    double period = 3;            ///< vortex: time after which the flow is back at its start
    double speed = 1;             ///< curl-noise: the largest
    double frequency = 3;         ///< curl-noise: wave lengths across the domain, at most
    std::uint64_t seed = 1;       ///< curl-noise
    bool has_walls = true;        ///< curl-noise: there is no torus
    Point2 direction = Point2(1, 0);
    Point2 gradient = Point2(0, 1);
    Point2 velocity = Point2::Zero();
    std::string expressions;  ///< expression: "(-y, x)" in x, y and t
    std::string path;         ///< grid: the VTI file
    std::string array;        ///< grid: its array; empty: the only one that is a velocity
};

struct Options {
    ShapeOptions shape;
    MotionOptions motion;
};

/// What only the plane has, on its way from the command line.
struct Texts {
    int sides = 6;
    bool is_torus = false;
};

/// Declares the options of the plane.
void add_options(apps::CommandLine& line, Texts& texts);

/// True when one of these stood on the command line.
bool is_any_given(const apps::CommandLine& line);

/// From what stood on the command line. Throws core::UsageError.
Options parsed_options(const apps::CommandLine& line, const flow::Options& common, const Texts& texts);

}  // namespace dsc::flow::planar
