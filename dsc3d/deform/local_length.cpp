// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/local_length.h"

#include <algorithm>
#include <limits>

namespace dsc::dsc3d {

LocalLength::LocalLength(const Mesh& mesh, double on_interface, double growth)
    : growth_(growth), length_(mesh.complex().vertex_attributes(), on_interface) {
    const Complex& complex = mesh.complex();
    constexpr double unknown = std::numeric_limits<double>::infinity();
    bool has_interface = false;
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i)
        has_interface = has_interface || (!complex.is_deleted(VertexId(i)) && complex.is_interface(VertexId(i)));
    if (!has_interface) return;
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i)
        if (!complex.is_deleted(VertexId(i)) && !complex.is_interface(VertexId(i))) length_[VertexId(i)] = unknown;
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
            if (complex.is_deleted(EdgeId(i))) continue;
            const auto [a, b] = complex.vertices(EdgeId(i));
            const double rise = growth_ * (mesh.position(a) - mesh.position(b)).norm();
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
                if (length_[from] + rise >= length_[to]) continue;
                length_[to] = length_[from] + rise;
                has_changed = true;
            }
        }
    }
}

void LocalLength::update(RatedMesh& mesh, std::span<const VertexId> vertices) {
    gather_followers(mesh, vertices);
    for (const Follower& follower : followers_) length_[follower.vertex] = allowed(follower);
    // Those that come early may have followed neighbours that have become smaller since.
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (const Follower& follower : followers_) {
            const double length = allowed(follower);
            if (length >= length_[follower.vertex]) continue;
            length_[follower.vertex] = length;
            has_changed = true;
        }
    }
}

void LocalLength::gather_followers(RatedMesh& mesh, std::span<const VertexId> vertices) {
    followers_.clear();
    neighbours_.clear();
    for (const VertexId v : vertices) {
        if (mesh.complex().is_interface(v)) continue;
        const std::size_t begin = neighbours_.size();
        mesh.walker().star(v, around_);
        for (const VertexId u : around_)
            neighbours_.push_back({u, growth_ * (mesh.position(u) - mesh.position(v)).norm()});
        followers_.push_back({v, begin, neighbours_.size()});
    }
}

double LocalLength::allowed(const Follower& follower) const {
    double length = std::numeric_limits<double>::infinity();
    for (std::size_t i = follower.begin; i < follower.end; ++i)
        length = std::min(length, length_[neighbours_[i].vertex] + neighbours_[i].rise);
    return length;
}

}  // namespace dsc::dsc3d
