// SPDX-License-Identifier: GPL-3.0-or-later
// What every pass of a step gets: the rated mesh, the thresholds, wanted lengths, where vertices wanted to go, and the
// region it has to visit. A pass adds to the region what it changes.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "dsc3d/deform/listener.h"
#include "dsc3d/deform/local_length.h"
#include "dsc3d/deform/parameters.h"
#include "dsc3d/deform/region.h"

namespace dsc::dsc3d {

struct PassContext {
    RatedMesh& mesh;
    const DeformParameters& parameters;
    LocalLength& wanted_length;
    const core::Attribute<VertexId, Point3>& way;  ///< of each vertex in this substep, whether it was made or not
    /// Of each vertex on the boundary in this substep: how far its motion leads off the wall, where it can't go.
    const core::Attribute<VertexId, Point3>& pull;
    Region& region;
    Listener& listener;
    StepReport& report;

    const Complex& complex() const { return mesh.complex(); }
    Point3 middle(EdgeId e) const { return mesh.middle(e); }
    double length(EdgeId e) const {
        const auto [a, b] = complex().vertices(e);
        return (mesh.position(a) - mesh.position(b)).norm();
    }
    /// The length of e over the mean of the lengths wanted at its ends.
    double relative_length(EdgeId e) const {
        const auto [a, b] = complex().vertices(e);
        return surface::relative_length(length(e), wanted_length.at(a), wanted_length.at(b));
    }
    double volume(TetId t) const {
        const TetVertices& v = complex().vertices(t);
        const Point3& a = mesh.position(v[0]);
        return (mesh.position(v[1]) - a).dot((mesh.position(v[2]) - a).cross(mesh.position(v[3]) - a)) / 6;
    }
    Point3 centroid(TetId t) const {
        const TetVertices& v = complex().vertices(t);
        return 0.25 * (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2]) + mesh.position(v[3]));
    }
    /// The least length wanted at the vertices of t.
    double least_wanted_length(TetId t) const {
        const TetVertices& v = complex().vertices(t);
        return std::min(std::min(wanted_length.at(v[0]), wanted_length.at(v[1])),
                        std::min(wanted_length.at(v[2]), wanted_length.at(v[3])));
    }
};

}  // namespace dsc::dsc3d
