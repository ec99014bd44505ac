// SPDX-License-Identifier: GPL-3.0-or-later
// A closed surface with edges of a given length, its sharp edges and corners kept.
// Source: M. Botsch, L. Kobbelt (2004), "A remeshing approach to multiresolution modeling", as CGAL's
// isotropic_remeshing has it. Guarantee: closed, manifold and without self-intersections; vertices are on the input
// surface within rounding, those of sharp edges on these, corners in their places; the same bits for the same input.
// Cost: some 50 microseconds per triangle of the result.
//
//     geometry::SurfaceData fine = dsc3d::remeshed(io::read_surface_mesh("fandisk.off"), {.edge_length = 0.02});
#pragma once

#include "geometry/surface_data.h"

namespace dsc::dsc3d {

struct RemeshParameters {
    double edge_length = 0;     ///< wanted, in the units of the surface; no default; > 0
    double feature_angle = 40;  ///< edges bent by more than this are kept [degree]; (0, 180]
    int iterations = 10;        ///< of splits, collapses, flips and smoothing; >= 1

    /// Throws core::UsageError naming the field.
    void validate() const;
};

/// Without labels. Throws core::UsageError for invalid parameters, more than 1e7 triangles, and when the surface is not
/// closed, manifold and oriented, core::RunError when the result meets itself because the edges are longer than the
/// surface is thick.
geometry::SurfaceData remeshed(const geometry::SurfaceData& surface, const RemeshParameters& parameters);

}  // namespace dsc::dsc3d
