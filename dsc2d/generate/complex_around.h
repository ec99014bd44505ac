// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh that a flow begins with: a domain filled with triangles around outlines, which are kept side by side.
// Source: thesis 4.3.1 (the mesh conforms to the initial interface). A structured mesh, the outlines put into it, and
// sweeps of mesh improvement (dsc2d/deform/deformer.h). Guarantee: a valid complex. Away from sharp corners and narrow
// gaps, angles are mostly above 20 degrees. Cost: linear in the mesh, some microseconds per triangle.
//
//     Complex complex = complex_around(Domain::box({0, 0}, {1, 1}), disc({0.5, 0.5}, 0.3, 0.01), 0.01);
#pragma once

#include <span>

#include "dsc2d/complex.h"
#include "dsc2d/generate/insert_polygon.h"

namespace dsc::dsc2d {

struct FillParameters {
    /// Side of the squares that are halved into triangles [edge_length]. > 0.
    double cell = 1.25;
    /// Rows and columns at most: beyond, the triangles grow away from the interface. >= 4.
    int max_cells = 512;
    /// Sweeps of improvement. >= 0.
    int sweeps = 12;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

/// Throws core::InputError as insert_regions does, core::Cancelled when the observer asks for an end.
Complex complex_around(const Domain& domain, std::span<const Region> regions, double edge_length,
                       const FillParameters& parameters = {}, const core::Observer& observer = {});

}  // namespace dsc::dsc2d
