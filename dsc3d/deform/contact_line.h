// SPDX-License-Identifier: GPL-3.0-or-later
// Where an interface that ends on a wall goes when its motion leads off the wall or into it. The sheets are taken to go
// on beyond the wall, with the curvature that they have in front of it: these move as asked for, and the contact line
// is where they meet the wall then. So what is pressed against a wall and pulled off again spreads and recedes as its
// shape wants; a sheet that stands upright on the wall stays where it is, and so does one that would spread, over the
// side of the lower label, by being pulled off: what hangs on a wall is drawn out, not widened. Source: the quadric of
// face offsetting (Jiao, "Face offsetting", 2007; thesis 4.4.1.3) restricted to the wall: with the normals N and areas
// A of the sheets at the vertex and w the motion off the wall, the slip s within the wall minimizes sum A (N . s - N .
// w)^2; the curvature adds its parabola to N . w. What an accident of contact has left in front of where the sheets
// behind it meet the wall, or short of it, comes back while they move. Guarantee: zero where w is; exact for planes;
// directions that no sheet determines get nothing. Cost: linear in the stars of two rings.
#pragma once

#include "dsc3d/deform/interface_ring.h"

namespace dsc::dsc3d {

struct ContactLineParameters {
    /// Sheets at a smaller angle to the wall don't drive the line: it would run away [degree]; (0, 90).
    double least_angle = 3;
    /// Of the square of the sine, relative to that of the steepest sheet: below, a second direction of motion is
    /// noise of the normals of one sheet; (0, 1).
    double least_ratio = 0.05;
    /// Of the sheet over the row of triangles at the line, by its curvature, at most [radian]; >= 0.
    double largest_bend = 0.5;
    /// The rows behind the line are one smooth sheet where the sum of their normals, weighted by area, is longer than
    /// this share of their area; (0, 1).
    double least_coherence = 0.9;
    /// What strays from that sheet comes back by no more than this share of the motion off the wall; >= 0.
    double recovery = 1;
};

/// The slip of an interface vertex on the boundary, along it, that goes with the part `off` of its motion that leads
/// off the wall.
Eigen::Vector3d contact_line_slip(RatedMesh& mesh, VertexId v, const Eigen::Vector3d& off, InterfaceRing& ring,
                                  const ContactLineParameters& parameters = {});

}  // namespace dsc::dsc3d
