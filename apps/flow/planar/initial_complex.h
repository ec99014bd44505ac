// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh that a flow in the plane begins with: of a shape by name, of polygons from a file, or a labelled planar
// mesh. Guarantee: label 0 is outside; sides of polygons are edges of the mesh, long ones divided; a mesh from a file,
// which has to fill a box, stays as it is. Cost: that of dsc2d/generate/complex_around.h.
#pragma once

#include "apps/flow/planar/options.h"
#include "core/observer.h"
#include "dsc2d/complex.h"
#include "dsc2d/deform/parameters.h"

namespace dsc::flow::planar {

struct InitialComplex {
    dsc2d::Complex complex;
    Eigen::AlignedBox2d domain;
    double edge_length = 0;
};

/// Throws core::InputError and core::UsageError.
InitialComplex initial_complex(const ShapeOptions& options, const core::Observer& observer = {});

/// Detail control keeps the edges of the interface about as long as they are at the start, and leaves those of the
/// start alone as long as they are not changed.
dsc2d::Parameters deformation(const InitialComplex& initial, motion::TopologyPolicy topology);

}  // namespace dsc::flow::planar
