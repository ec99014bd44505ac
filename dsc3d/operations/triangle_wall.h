// SPDX-License-Identifier: GPL-3.0-or-later
// Walls given by triangles: the sides of a container of any shape. Its surface is cut along its sharp edges into smooth
// pieces, each a wall of its own, so that what slides on one does not get around an edge. Source: as wall.h. Guarantee:
// nearest places are exact up to rounding; normals are continuous within a piece. Const calls may come from several
// threads. Cost: n log n in the triangles to make; a query some log n.
//
//     const Walls walls = container_walls(container);
//     Deformer deformer(mesh, {.edge_length = 0.02}, listener, walls);
#pragma once

#include <memory>

#include "dsc3d/operations/wall.h"
#include "geometry/surface_data.h"

namespace dsc::dsc3d {

class TriangleWall final : public Wall {
public:
    /// All triangles of the surface, a smooth piece. Throws core::UsageError when there are none.
    explicit TriangleWall(const geometry::SurfaceData& surface);
    ~TriangleWall() override;

    Point3 nearest(const Point3& p) const override;
    /// Interpolated from those at the vertices: the wall's triangles approximate a smooth surface.
    Eigen::Vector3d normal(const Point3& p) const override;

private:
    class Tree;
    std::unique_ptr<const Tree> tree_;
};

struct ContainerParameters {
    double feature_angle = 30;  ///< edges bent by more are sharp [degree]
    double tolerance = 1e-9;    ///< of pieces that are plane [diagonals of the bounding box]
};

/// The curved pieces of a closed surface; those that are plane need no wall. Precondition: every edge has two triangles
/// that run through it in opposite directions.
Walls container_walls(const geometry::SurfaceData& container, const ContainerParameters& parameters = {});

}  // namespace dsc::dsc3d
