// SPDX-License-Identifier: GPL-3.0-or-later
// The thresholds of the 3D deformation; small ones of a single pass stand with it. Lengths are in units of the wanted
// edge length at the place, qualities are minimum sines of dihedral angles: 0.26 for an angle of 15 degrees. Source:
// thesis 4.3.1, 4.3.2.
#pragma once

#include <cstdint>

#include "motion/topology.h"
#include "surface/edge_collapse.h"
#include "surface/edge_flip.h"
#include "surface/edge_length.h"
#include "surface/edge_split.h"
#include "surface/null_space_smoothing.h"

namespace dsc::dsc3d {

struct DeformParameters {
    /// Target length of the edges of the interface, in the units of the mesh. No default; > 0.
    double edge_length = 0;
    /// How fast wanted lengths grow off the interface, per distance. >= 0.
    double growth = 0.6;
    /// Of everything random.
    std::uint64_t seed = 1;

    // Topology
    /// What happens where parts of the interface meet.
    motion::TopologyPolicy topology = motion::TopologyPolicy::adaptive;
    /// The label between objects: where it is squeezed away, objects merge; where another one is, that object splits.
    int background_label = 0;
    /// Parts of the interface that come closer than this meet. > 0.
    double contact_distance = 0.25;
    /// ... if the cosine of the angle between their normals is below this. In (-1, 0).
    double contact_cosine = -0.3;
    /// ... and a sheet with a wall, if the cosine of the angle between its normal and that of the wall is below this:
    /// steeper ones meet it at a contact line, which moves. In (-1, 0).
    double wall_cosine = -0.85;
    /// A waist is squeezed away where an edge across it is shorter than this share of the distance: in a groove an edge
    /// may go from side to side too, but hardly a shorter one. In (0, 1].
    double waist_share = 0.5;
    /// The region between them is squeezed away where it is thinner than this, >= contact_distance,
    double gap_width = 0.5;
    /// ... and this near to the place where they met. >= 0.
    double gap_reach = 2;
    /// The last of a region's contact with a wall is let go where it is no wider than this and contracts. > 0.
    double foot_width = 2;
    /// What is left over and smaller than this, in cubed edge lengths, goes with it. >= 0.
    double crumb_volume = 0.3;
    /// Where the topology is preserved, the end of a thread goes that has less of its region around it than this, in
    /// cubed edge lengths. >= 0.
    double thread_volume = 0.02;

    // Motion
    /// The way of a vertex in one substep. > 0.
    double stride = 0.5;
    /// What is left of a substep is cut into as many parts, at most, so that no contact line slips by more than that in
    /// one of them. >= 1.
    int most_line_substeps = 8;
    /// Steps that would take more substeps are refused. >= 1.
    int most_substeps = 100000;
    /// Substeps beyond each that the stride asks for, before what is late is left behind. >= 1.
    int max_substeps = 40;
    /// ... and no more than this many that leave the following share of the way. >= 1, in (0, 1].
    int max_stalls = 3;
    double stalling_share = 0.9;
    /// Share of the way to the link that a blocked vertex makes. In (0, 1).
    double approach = 0.9;
    /// No motion makes a tetrahedron worse than this. In (0, bad_quality).
    double stopping_quality = 0.06;
    /// Rings of vertices off the interface that are carried along with it. >= 0.
    int carried_rings = 3;

    // Tetrahedra
    bool improves_quality = true;
    /// What hill climbing does: moves vertices, removes edges and faces, collapses edges.
    bool smooths = true;
    bool flips = true;
    bool thins = true;
    /// Tetrahedra below this are improved. In (0, 1).
    double poor_quality = 0.26;
    /// Tetrahedra that stay below this in spite of it are escaped from, or get a vertex. In [0, poor_quality].
    double bad_quality = 0.23;
    /// Rounds of hill climbing, and of escapes. >= 1.
    int upkeep_rounds = 10;
    /// Random attempts to escape from one bad tetrahedron. >= 0.
    int escape_attempts = 20;
    /// ... but not more in all, each time, than this and this share of the tetrahedra that have changed. >= 0.
    int least_escapes = 20;
    double escape_share = 0.01;
    /// Edges shorter than this get no vertex for the sake of quality: thin parts would be filled with ever smaller
    /// tetrahedra. >= 0.
    double insertion_edge = 1;
    /// How many times better a new vertex has to make the worst tetrahedron around it. >= 1.
    double insertion_gain = 1.2;

    // Edges off the interface
    bool controls_detail = true;
    /// Longer ones are halved. > 0.
    double max_edge = 2.2;
    /// Shorter ones are collapsed. In [0, max_edge / 2].
    double min_edge = 0.75;
    /// ... if that leaves the tetrahedra better than this, or better than they are. In (0, 1).
    double collapse_quality = 0.3;

    // The interface as a surface
    bool controls_interface = true;
    /// What it does to the interface.
    bool collapses_interface = true;
    bool splits_interface = true;
    bool flips_interface = true;
    bool smooths_interface = true;
    /// Its operations make no tetrahedron worse than this, or than it is. In (0, 1).
    double interface_quality = 0.1;
    /// Its edges that are shorter than this are collapsed, and triangles lower than this are flipped away, whatever
    /// that does to the shape. In [0, 0.5).
    double degenerate_edge = 0.3;
    double degenerate_height = 0.1;
    surface::EdgeLengthParameters interface_lengths = {};
    /// Along contact lines, whose spacing the motion of the line is taken from: more even than elsewhere.
    surface::EdgeLengthParameters contact_line_lengths = {.split_above = 1.4, .collapse_below = 0.6};
    surface::SplitParameters interface_split = {};
    surface::CollapseParameters interface_collapse = {};
    surface::FlipParameters interface_flip = {};
    surface::SmoothingParameters interface_smoothing = {};

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

}  // namespace dsc::dsc3d
