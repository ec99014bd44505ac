// SPDX-License-Identifier: GPL-3.0-or-later
// What a run of the program fluid is about: bodies of fluid in a box, with its material. Some scenes have names; others
// come from JSON files. Source: thesis 6.5 for those with names.
//
//     { "domain": [[-2, -2, -2], [2, 2, 2]], "edge_length": 0.15, "tension": 1, "gravity": [0, 0, 0],
//       "bodies": [ {"shape": "sphere", "centre": [0, 0, 0], "radius": 1, "velocity": [0, 0, 1]} ] }
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "geometry/predicates.h"
#include "io/json.h"

namespace dsc::fluid_app {

using geometry::Point3;

/// A ball of fluid, or another shape that just fits in one.
struct Ball {
    Point3 centre = Point3::Zero();
    double radius = 1;  ///< > 0
    Point3 velocity = Point3::Zero();
    Point3 spin = Point3::Zero();  ///< angular velocity
    double swell = 0;              ///< share of the radius by which the poles in direction z stand out; in (-0.5, 0.5)
    std::optional<std::string> surface = {};  ///< file of a closed surface, which is scaled to fit in the ball
};

/// A hollow solid, filled with fluid and void: it is the domain, instead of a box.
struct Vessel {
    Point3 centre = Point3::Zero();
    double radius = 1;  ///< > 0
};

struct Scene {
    std::string name;
    Eigen::AlignedBox3d domain = {Point3::Constant(-2), Point3::Constant(2)};
    double edge_length = 0.15;  ///< of the surface; > 0
    std::vector<Ball> balls;
    std::optional<double> depth;           ///< of a layer on the floor of the domain, which is a tank then; > 0
    std::optional<Point3> column;          ///< size of a block in the lower corner of the domain; > 0
    std::optional<double> sessile_radius;  ///< of half a ball on the middle of the floor; > 0
    std::optional<Vessel> vessel;          ///< in which the balls are
    double density = 1;
    double tension = 1;
    double viscosity = 0;
    double wetting = 0;  ///< alpha_1 - alpha_2 of the walls; in [-1, 1]
    Point3 gravity = Point3::Zero();
    double until = 1;  ///< end of the run, > 0
};

std::vector<std::string> scene_names();

/// Precondition: it is one of the names.
Scene named_scene(const std::string& name);

/// Throws core::InputError that names the file and the path of the member in it: one that does not exist, has another
/// type or is out of its range.
Scene scene_from_json(const io::Json& json, const std::string& source);

/// Throws core::InputError, which names `source` and the member, when bodies are not in the domain, or meet, or would
/// take more cells than can be had.
void require_consistent(const Scene& scene, const std::string& source);

}  // namespace dsc::fluid_app
