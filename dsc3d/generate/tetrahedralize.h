// SPDX-License-Identifier: GPL-3.0-or-later
// A labelled tetrahedral mesh of a box in which given triangles are faces between labels: the start of a deformation.
// Source: thesis 4.3 (the interface is a subcomplex of the tetrahedral mesh), 3.5 (TetGen). Free vertices are placed
// where good tetrahedra want them (graded_points.h), TetGen connects all, and mesh improvement (thesis ch. 3) raises
// the quality without touching the triangles.
// Guarantee: every triangle given is a face, with the coordinates given, and no other face separates labels; sizes of
// the tetrahedra grow with the distance from them. Dihedral angles are at least `min_angle`, unless the surface itself
// has sharper ones or leaves no room. The same bits for the same input. Cost: some 7 tetrahedra per triangle, 120
// microseconds each.
//
//     const Eigen::AlignedBox3d box(Point3(0, 0, 0), Point3(1, 1, 1));
//     dsc3d::Mesh mesh(dsc3d::tetrahedralize(dsc3d::icosphere(box.center(), 0.3, 8), box, {}, observer));
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "core/observer.h"
#include "geometry/interface_data.h"
#include "geometry/predicates.h"
#include "geometry/tet_data.h"

namespace dsc::dsc3d {

using geometry::Point3;

struct TetrahedralizeParameters {
    double growth = 1;  ///< of the edge length per distance from the surface; [0, 2]
    /// Improvement goes on until all dihedral angles are at least this, or it can't be reached [degree]; (0, 40].
    double min_angle = 15;
    std::string tetgen = "tetgen";  ///< the program, by name or path

    /// Throws core::UsageError naming the field.
    void validate() const;
};

/// The surface may have many parts, one within the other. The label of a region is its winding number: 0 outside, one
/// more behind a triangle (on the side its normal points away from) than in front of it. So parts side by side have
/// label 1, a cavity whose normals point into it has label 0, and a ball within a ball label 2. A surface that is
/// inside out as a whole is turned. Throws core::UsageError when the surface is not closed, manifold and oriented,
/// meets itself (io/closed_surface.h says where), has a part that is inside out, or is not inside the box, and
/// core::RunError when TetGen fails.
geometry::TetData tetrahedralize(const geometry::SurfaceData& surface, const Eigen::AlignedBox3d& box,
                                 const TetrahedralizeParameters& parameters, core::Observer& observer);

/// Any number of labels that may meet along edges: each region gets the label that its triangles have on its side, and
/// one without triangles 0. Throws as above, and core::UsageError for triangles that disagree about a region.
geometry::TetData tetrahedralize(const geometry::InterfaceData& interface, const Eigen::AlignedBox3d& box,
                                 const TetrahedralizeParameters& parameters, core::Observer& observer);

}  // namespace dsc::dsc3d
