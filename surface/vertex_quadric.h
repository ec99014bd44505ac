// SPDX-License-Identifier: GPL-3.0-or-later
// The quadric of the normals at a vertex and its eigenvectors: which directions the surface at the vertex fixes (its
// primary space), and in which the vertex can slide (its null space).
// Source: thesis 4.3.2.2; Jiao (2007), "Face offsetting: a unified approach for explicit moving interfaces". Triangles
// weigh by their angle at the vertex, where Jiao has their area: for a surface of planes no triangulation of them
// changes the quadric then. Cost: linear in the ring and one 3x3 eigenproblem, no allocation.
#pragma once

#include <Eigen/Core>

#include "surface/one_ring.h"

namespace dsc::surface {

struct VertexQuadric {
    Vector3 values = Vector3::Zero();                       ///< eigenvalues, decreasing; their sum is 1
    Eigen::Matrix3d vectors = Eigen::Matrix3d::Identity();  ///< unit eigenvectors as columns, in that order
    Vector3 mean_normal = Vector3::Zero();                  ///< weighted mean of the unit normals

    Vector3 vector(int k) const { return vectors.col(k); }
    /// Dimension of the primary space: 1 on a smooth piece, 2 on a ridge, 3 at a corner; 0 when no triangle has a
    /// normal.
    ///
    /// Two planes whose normals are `angle` apart give the ratio tan^2(angle / 2) of the second eigenvalue to the first
    /// one, so that directions count whose ratio is above that of `feature_angle` [degree]. Two planes almost on top of
    /// each other (the rim of a thin sheet) give a small ratio too, but hardly any mean normal.
    int rank(double feature_angle) const;
};

VertexQuadric vertex_quadric(const OneRing& ring);

}  // namespace dsc::surface
