// SPDX-License-Identifier: GPL-3.0-or-later
// One step of mean curvature flow of any length: the metric of the surface as it is, the positions of the end.
// Source: Desbrun, Meyer, Schröder, Barr (1999), "Implicit Fairing of Irregular Meshes using Diffusion and Curvature
// Flow"; speed and weights of surface/curvature.h. Solves (M + dt L) x' = M x with the mixed areas M and the cotangent
// Laplacian L. Guarantee: stable for every step; first order in time: a sphere of radius r gets r / (1 + 2 dt / r^2).
// Cost: one sparse Cholesky factorization, about n^1.5 for n vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/surface_data.h"
#include "surface/one_ring.h"

namespace dsc::surface {

/// The positions of all vertices after `dt` > 0. A vertex whose entry in `is_fixed` is not 0 stays, and so does one
/// that is in no triangle; no entries at all: none is fixed. Throws core::RunError when the system can't be solved,
/// which happens for a surface of triangles without area only.
std::vector<Point3> implicit_curvature_step(const geometry::SurfaceData& surface, double dt,
                                            std::span<const std::uint8_t> is_fixed = {});

}  // namespace dsc::surface
