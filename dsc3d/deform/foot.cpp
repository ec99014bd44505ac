// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/foot.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace dsc::dsc3d {

bool Foot::find(PassContext& context, FaceId f) {
    if (!gather_patch(context, f) || !(is_contracting(context) || is_pulled_off(context))) return false;
    gather_tets(context, context.complex().label(context.complex().tets(f)[0]));
    return true;
}

// The faces that hang together without an edge of the interface; false when they reach too far.
bool Foot::gather_patch(PassContext& context, FaceId f) {
    const Complex& complex = context.complex();
    double widest = context.parameters.foot_width * context.least_wanted_length(complex.tets(f)[0]);
    widest *= widest;
    seen_faces_.clear();
    seen_vertices_.clear();
    seen_faces_.add(f);
    patch_ = {f};
    vertices_.clear();
    for (std::size_t i = 0; i < patch_.size(); ++i) {
        for (const VertexId v : complex.vertices(patch_[i])) {
            if (!seen_vertices_.add(v)) continue;
            const Point3& p = context.mesh.position(v);
            const auto is_far = [&](VertexId u) { return (context.mesh.position(u) - p).squaredNorm() > widest; };
            if (std::any_of(vertices_.begin(), vertices_.end(), is_far)) return false;
            vertices_.push_back(v);
        }
        for (const EdgeId e : complex.edges(patch_[i])) {
            if (complex.is_interface(e)) continue;
            gather_ring(complex, e, ring_);
            const std::size_t n = ring_.tets.size();
            for (const auto& [t, opposite] :
                 {std::pair(ring_.tets[0], ring_.link[1]), std::pair(ring_.tets[n - 1], ring_.link[n - 1])}) {
                const FaceId next = complex.faces(t)[static_cast<std::size_t>(complex.index_of(t, opposite))];
                if (seen_faces_.add(next)) patch_.push_back(next);
            }
        }
    }
    return true;
}

// Its rim goes towards its middle.
bool Foot::is_contracting(const PassContext& context) const {
    Point3 middle = Point3::Zero();
    for (const VertexId v : vertices_) middle += context.mesh.position(v) / static_cast<double>(vertices_.size());
    double outwards = 0, all = 0;
    for (const VertexId v : vertices_) {
        if (!context.complex().is_interface(v)) continue;
        const Eigen::Vector3d from_middle = context.mesh.position(v) - middle;
        outwards += context.way[v].dot(from_middle);
        all += context.way[v].norm() * from_middle.norm();
    }
    // What slides along differs in its ways by rounding.
    constexpr double rounding = 1e-9;
    return outwards < -rounding * all;
}

// Its rim wants to go into the domain, by more than along the wall.
bool Foot::is_pulled_off(const PassContext& context) const {
    const Complex& complex = context.complex();
    Eigen::Vector3d inwards = Eigen::Vector3d::Zero();
    for (const FaceId f : patch_) {
        const TetId t = complex.tets(f)[0];
        const FaceVertices face = complex.oriented_face(t, complex.index_of(t, f));
        const Point3& p = context.mesh.position(face[0]);
        inwards -= (context.mesh.position(face[1]) - p).cross(context.mesh.position(face[2]) - p);
    }
    inwards.normalize();
    double off = 0, along = 0;
    for (const VertexId v : vertices_) {
        if (!complex.is_interface(v)) continue;
        off += context.pull[v].dot(inwards);
        along += context.way[v].norm();
    }
    return off > along;
}

void Foot::gather_tets(PassContext& context, int label) {
    seen_tets_.clear();
    tets_.clear();
    for (const VertexId v : vertices_)
        for (const TetId t : context.mesh.walker().star(v))
            if (context.complex().label(t) == label && seen_tets_.add(t)) tets_.push_back(t);
}

}  // namespace dsc::dsc3d
