// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/move_to_link.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace dsc::dsc3d {

namespace {

double signed_volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return (b - a).dot((c - a).cross(d - a)) / 6;
}

// The share of the way to its target at which v meets the plane of a face of its link, or more than 1.
double share_to_link(const RatedMesh& mesh, std::span<const TetId> star, VertexId v, const Point3& target) {
    double share = std::numeric_limits<double>::infinity();
    for (const TetId t : star) {
        const FaceVertices face = mesh.complex().oriented_face(t, mesh.complex().index_of(t, v));
        const Point3 &b = mesh.position(face[0]), &c = mesh.position(face[1]), &d = mesh.position(face[2]);
        const double here = signed_volume(mesh.position(v), b, c, d), there = signed_volume(target, b, c, d);
        if (there < here) share = std::min(share, here / (here - there));
    }
    return share;
}

}  // namespace

bool move_to_link(RatedMesh& mesh, VertexId v, const Point3& target, const MoveToLinkParameters& parameters) {
    const std::span<const TetId> star = mesh.walker().star(v);
    const Point3 start = mesh.position(v);
    const double least = std::min(mesh.worst_quality(star), parameters.least_quality);
    const double to_link = share_to_link(mesh, star, v, target);
    if (to_link > 1 && mesh.move(v, target, star, least)) return true;
    for (double share = parameters.approach * std::min(to_link, 1.0); share > parameters.least_share; share *= 0.5)
        if (mesh.move(v, mesh.on_boundary(v, start + share * (target - start)), star, least)) break;
    return false;
}

}  // namespace dsc::dsc3d
