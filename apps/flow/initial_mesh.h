// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh that a flow begins with: of a shape by name, around a surface from a file, or from a file of labelled
// tetrahedra. Guarantee: label 0 is outside; the triangles of a surface are faces of the mesh, as given or remeshed;
// dihedral angles are at least 15 degrees where the surface and the room left allow it (not for tetrahedra from a file,
// which are as in the file). Cost: that of dsc3d/generate/tetrahedralize.h.
#pragma once

#include "apps/flow/options.h"
#include "core/observer.h"
#include "dsc3d/operations/wall.h"
#include "geometry/interface_data.h"
#include "geometry/tet_data.h"

namespace dsc::flow {

struct InitialMesh {
    geometry::TetData data;
    Eigen::AlignedBox3d domain;    ///< or the box around it
    double edge_length = 0;        ///< mean of the interface
    bool may_be_too_fine = false;  ///< off the interface: it was not made for a flow
};

/// Throws core::InputError, core::UsageError and core::RunError.
InitialMesh initial_mesh(const ShapeOptions& options, core::Observer& observer);

/// The curved walls of the domain. Throws core::InputError.
dsc3d::Walls domain_walls(const ShapeOptions& options);

/// The surface of a shape by name, with the labels on either side. Precondition: not a file.
geometry::InterfaceData shape_surface(const ShapeOptions& options);

}  // namespace dsc::flow
