// SPDX-License-Identifier: GPL-3.0-or-later
// Splits: a new vertex on an edge, in a face or in a tetrahedron, whose tetrahedra it divides.
// Source: thesis 2.1.5, 3.2 (vertex insertion), 4.3. Guarantee: a split of the complex is always possible and changes
// no topology; a split of a mesh at a place that can_split accepts leaves all tetrahedra positive by exact predicate.
// The parts inherit the label, so that a vertex on a surface edge or face is one of the surface.
// Cost: linear in the ring of the edge, else constant.
//
//     const Point3 middle = 0.5 * (mesh.position(a) + mesh.position(b));
//     if (can_split(mesh, e, middle)) split(mesh, e, middle);
#pragma once

#include "dsc3d/complex/traversal.h"
#include "dsc3d/mesh.h"

namespace dsc::dsc3d {

/// The new vertex; its attributes have their defaults.
VertexId split(Complex& complex, EdgeId e);
VertexId split(Complex& complex, FaceId f);
VertexId split(Complex& complex, TetId t);

/// True when all parts are positive with the new vertex at `position`. On the surface, the new faces lie in the planes
/// of the old ones only where `position` does.
bool can_split(const Mesh& mesh, EdgeId e, const Point3& position);
bool can_split(const Mesh& mesh, FaceId f, const Point3& position);
bool can_split(const Mesh& mesh, TetId t, const Point3& position);

/// Precondition: can_split.
VertexId split(Mesh& mesh, EdgeId e, const Point3& position);
VertexId split(Mesh& mesh, FaceId f, const Point3& position);
VertexId split(Mesh& mesh, TetId t, const Point3& position);

}  // namespace dsc::dsc3d
