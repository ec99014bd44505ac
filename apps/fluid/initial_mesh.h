// SPDX-License-Identifier: GPL-3.0-or-later
// The tetrahedra and velocities that a scene begins with: label 1 is fluid, 0 void. Guarantee: balls have the shape of
// least surface for their triangles (a drop of it is exactly at rest), stretched where the scene says so; the surface
// of a tank is flat. The same bits for the same scene.
#pragma once

#include <vector>

#include "apps/fluid/scene.h"
#include "core/observer.h"
#include "geometry/tet_data.h"

namespace dsc::fluid_app {

struct InitialMesh {
    geometry::TetData tets;
    std::vector<Point3> velocities;  ///< of the vertices; zero off the fluid
    double edge_length = 0;          ///< of the surface on average
};

/// Throws core::UsageError as tetrahedralize() does, and core::InputError for a surface that is not closed.
InitialMesh initial_mesh(const Scene& scene, core::Observer& observer);

}  // namespace dsc::fluid_app
