// SPDX-License-Identifier: GPL-3.0-or-later
// All thresholds of the 2D deformation. Lengths are in units of `edge_length`, areas in units of its square.
// Source: thesis 4.3.1, 5.2.2.
#pragma once

#include <numbers>
#include <optional>

#include "motion/topology.h"

namespace dsc::dsc2d {

struct Parameters {
    /// Target length of the edges of the interface, in the units of the domain. No default; > 0.
    double edge_length = 0.0;

    /// What happens when parts of the interface meet.
    motion::TopologyPolicy topology = motion::TopologyPolicy::adaptive;
    /// Label of the region in which objects move; tells a merge from a split. Any.
    int background_label = 0;

    /// Algorithm 4: substeps before unfinished motion is reported. >= 1.
    int max_substeps = 10;
    /// Share of the way to the link that a blocked vertex makes, away from the interface. In (0, 1).
    double approach = 0.9;
    /// The same where the link is on the interface: the other side keeps its share of the gap. In (0, 1).
    double interface_approach = 0.5;
    /// Flips that make way for one vertex in one substep. >= 0.
    int flips_on_the_way = 16;

    /// Parts of the interface nearer than this touch. [edge_length], in (0, 1).
    double contact_distance = 0.25;
    /// ... and nearer than this share of the interface edges there. In (0, 1).
    double contact_fraction = 0.5;
    /// Nearer than this they touch however small the interface edges there are. [edge_length], in (0,
    /// contact_distance].
    double contact_minimum = 0.02;
    /// Neighbours of one interface vertex touch only when the angle between them is below this. [rad], in (0, pi).
    double contact_wedge = std::numbers::pi / 6.0;
    /// Substeps after which a vertex that the interface keeps from moving counts as touching it. >= 1.
    int blocked_substeps = 8;
    /// ... if it moves by less than this in each of them, and has more than this left to go. [edge_length], > 0.
    double blocked_motion = 0.05;

    /// Number of Laplacian smoothing sweeps over the active vertices per step. >= 0.
    int smoothing_sweeps = 1;

    /// Faces with a smaller angle are degenerate. [rad], in [0, pi/3).
    double degenerate_angle = 0.5 * std::numbers::pi / 180.0;
    /// Faces with a smaller area are degenerate. [edge_length^2], >= 0.
    double degenerate_area = 1e-3;

    /// Edges at vertices off the interface that are shorter are collapsed. [edge_length], >= 0.
    double steiner_min_edge = 0.5;
    /// ... unless a face would get an angle below this and below what is there already. [rad], in [0, pi/3).
    double steiner_min_angle = 10.0 * std::numbers::pi / 180.0;
    /// Vertices off the interface at faces with a smaller angle are put elsewhere or removed, if that leaves larger
    /// angles; nothing: none. [rad], in (0, pi/3).
    std::optional<double> poor_angle = std::nullopt;
    /// Faces with a smaller angle are needles, whose longest edge off the interface is halved; nothing: none. [rad], in
    /// (0, pi/3).
    std::optional<double> needle_angle = std::nullopt;
    /// ... if it exceeds this. [edge_length], > 0.
    double needle_min_length = 3.0;

    /// Interface edges that are longer are halved; nothing: never. [edge_length], > 0.
    std::optional<double> interface_max_edge = std::nullopt;
    /// Interface edges that are shorter are collapsed; nothing: never. [edge_length], > 0, below half of the maximum.
    std::optional<double> interface_min_edge = std::nullopt;

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const;
};

}  // namespace dsc::dsc2d
