// SPDX-License-Identifier: GPL-3.0-or-later
// A labelled tetrahedral mesh of the inside of a closed surface: a domain that is no box. Source and cost: those of
// tetrahedralize.h, which fills a box around the vessel; what lies outside is left away. Guarantee: that of
// tetrahedralize.h; every triangle of the vessel is a face of the boundary, and there are no others.
//
//     const geometry::SurfaceData vessel = dsc3d::icosphere(Point3(0, 0, 0), 1, 12);
//     dsc3d::Mesh mesh(dsc3d::tetrahedralize_within(interface, vessel, {}, observer));
#pragma once

#include "dsc3d/generate/tetrahedralize.h"

namespace dsc::dsc3d {

/// `interface` as in tetrahedralize(): what has no triangles gets label 0. Throws as that, and core::UsageError when
/// the vessel is not closed and oriented, with normals outwards, or the interface is not inside it.
geometry::TetData tetrahedralize_within(const geometry::InterfaceData& interface, const geometry::SurfaceData& vessel,
                                        const TetrahedralizeParameters& parameters, core::Observer& observer);

}  // namespace dsc::dsc3d
