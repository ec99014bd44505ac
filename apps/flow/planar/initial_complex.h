// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh that a flow in the plane begins with: of a shape by name, of polygons from a file, or a labelled planar
// mesh. Guarantee: label 0 is outside; sides of polygons are edges of the mesh, long ones divided; a mesh from a file,
// which has to fill a box, stays as it is. Cost: that of dsc2d/generate/complex_around.h.
#pragma once

#include "apps/flow/planar/options.h"
#include "core/fields.h"
#include "core/observer.h"
#include "dsc2d/complex.h"
#include "dsc2d/deform/parameters.h"

namespace dsc::flow::planar {

struct InitialComplex {
    dsc2d::Complex complex;
    Eigen::AlignedBox2d domain;
    double edge_length = 0;
};

/// That of a mesh in this box.
dsc2d::Domain domain_of(const Eigen::AlignedBox2d& box, bool is_torus);

/// Throws core::InputError and core::UsageError.
InitialComplex initial_complex(const ShapeOptions& options, const core::Observer& observer = {});

/// What detail control keeps the edges of the interface between.
struct EdgeLimits {
    double edge_length = 0;            ///< wanted
    double shortest = 0, longest = 0;  ///< [edge_length]
};

template <class Visitor, core::ConstOrNot<EdgeLimits> Value>
void fields(Visitor& visitor, Value& limits) {
    auto& [edge_length, shortest, longest] = limits;
    visitor(edge_length, shortest, longest);
}

/// They keep the edges about as long as they are at the start, and leave those of the start alone as long as they are
/// not changed.
EdgeLimits edge_limits(const InitialComplex& initial);

dsc2d::Parameters deformation(const EdgeLimits& edges, motion::TopologyPolicy topology);

}  // namespace dsc::flow::planar
