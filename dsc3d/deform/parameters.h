// SPDX-License-Identifier: GPL-3.0-or-later
// All thresholds of the 3D deformation. Lengths are in units of `edge_length`, qualities are volume-length ratios.
// Source: thesis 4.3.1, 4.3.2.
#pragma once

namespace dsc::dsc3d {

struct DeformParameters {
    /// Target length of the edges of the interface, in the units of the mesh. No default; > 0.
    double edge_length = 0;

    /// Algorithm 4: substeps before unfinished motion is reported. >= 1.
    int max_substeps = 10;
    /// Share of the way to the link that a blocked vertex makes. In (0, 1).
    double approach = 0.9;
    /// A vertex stops before the worst tetrahedron at it falls below this. In (0, poor_quality).
    double stopping_quality = 0.01;

    /// Tetrahedra below this are improved. In (0, 1).
    double poor_quality = 0.35;
    /// Tetrahedra that stay below this in spite of improvement are removed by a collapse. In [0, poor_quality).
    double degenerate_quality = 0.02;

    /// Edges off the interface that are shorter are collapsed. [edge_length], >= 0.
    double min_edge = 0.4;
    /// ... if that leaves the tetrahedra better than this, or better than they are. In (0, 1).
    double collapse_quality = 0.25;
    /// Edges off the interface that join it to itself or to the boundary are halved when longer. [edge_length], > 0.
    double max_bridge = 2.5;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

}  // namespace dsc::dsc3d
