// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/shrinking_front.h"

#include <algorithm>
#include <queue>
#include <vector>

#include "core/errors.h"

namespace dsc::reconstruct {

namespace {

using dsc3d::EdgeId;
using dsc3d::FaceId;
using dsc3d::TetId;
using dsc3d::VertexId;

class ShrinkingFront {
public:
    ShrinkingFront(const dsc3d::Mesh& mesh, const KdTree& cloud)
        : mesh_(mesh),
          complex_(mesh.complex()),
          cloud_(cloud),
          is_passed_(complex_.tet_capacity(), 0),
          faces_at_edge_(complex_.edge_capacity(), 0),
          faces_at_vertex_(complex_.vertex_capacity(), 0) {
        for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i)
            if (!complex_.is_deleted(FaceId(i)) && complex_.is_boundary(FaceId(i))) count(FaceId(i), 1);
    }

    // Again and again, because a tetrahedron may become simple by what happens across its edges and vertices.
    void run() {
        for (bool has_moved = true; has_moved;) {
            has_moved = false;
            for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i) {
                const FaceId f(i);
                if (complex_.is_deleted(f) || !is_front(f)) continue;
                for (const TetId t : complex_.tets(f)) offer(t);
            }
            while (!queue_.empty()) {
                const TetId t = queue_.top().second;
                queue_.pop();
                if (is_passed(t) || !is_simple(t)) continue;
                pass(t);
                has_moved = true;
            }
        }
    }

    bool is_passed(TetId t) const { return is_passed_[t.index()] != 0; }

private:
    /// Beyond the boundary everything has been passed.
    bool is_front(FaceId f) const {
        const auto& [here, there] = complex_.tets(f);
        return is_passed(here) != (!there.is_valid() || is_passed(there));
    }

    /// The front meets t in one, two or three of its faces and nothing else.
    bool is_simple(TetId t) const {
        std::array<bool, 4> is_at_front{};
        std::array<VertexId, 2> opposite;  // of the faces at the front, the first two
        std::size_t count = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            is_at_front[k] = is_front(complex_.faces(t)[k]);
            if (!is_at_front[k]) continue;
            if (count < 2) opposite[count] = complex_.vertices(t)[k];
            ++count;
        }
        if (count == 1) return faces_at_vertex_[opposite[0].index()] == 0;
        if (count == 2) return faces_at_edge_[edge_between(t, opposite[0], opposite[1]).index()] == 0;
        return count == 3;
    }

    EdgeId edge_between(TetId t, VertexId a, VertexId b) const {
        const std::array<EdgeId, 6> edges = complex_.edges(t);
        return *std::find_if(edges.begin(), edges.end(), [&](EdgeId e) {
            const auto& [p, q] = complex_.vertices(e);
            return (p == a && q == b) || (p == b && q == a);
        });
    }

    void pass(TetId t) {
        for (const FaceId f : complex_.faces(t))
            if (is_front(f)) count(f, -1);
        is_passed_[t.index()] = 1;
        for (const FaceId f : complex_.faces(t))
            if (is_front(f)) count(f, 1);
        for (int k = 0; k < 4; ++k) offer(complex_.neighbour(t, k));
    }

    void offer(TetId t) {
        if (!t.is_valid() || is_passed(t) || complex_.label(t) == inside_label) return;
        Point3 middle = Point3::Zero();
        for (const VertexId v : complex_.vertices(t)) middle += mesh_.position(v) / 4;
        queue_.emplace(cloud_.nearest(middle).squared_distance, t);
    }

    void count(FaceId f, int change) {
        for (const EdgeId e : complex_.edges(f)) faces_at_edge_[e.index()] += change;
        for (const VertexId v : complex_.vertices(f)) faces_at_vertex_[v.index()] += change;
    }

    const dsc3d::Mesh& mesh_;
    const dsc3d::Complex& complex_;
    const KdTree& cloud_;
    std::vector<std::uint8_t> is_passed_;
    std::vector<int> faces_at_edge_, faces_at_vertex_;  ///< of the front
    std::priority_queue<std::pair<double, TetId>> queue_;
};

}  // namespace

void shrink_to_genus_zero(dsc3d::Mesh& mesh, const KdTree& cloud) {
    dsc3d::Complex& complex = mesh.complex();
    ShrinkingFront front(mesh, cloud);
    front.run();
    for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i) {
        const TetId t(i);
        if (complex.is_deleted(t)) continue;
        const bool is_at_box = std::any_of(complex.faces(t).begin(), complex.faces(t).end(),
                                           [&](FaceId f) { return complex.is_boundary(f); });
        if (is_at_box && !front.is_passed(t))
            throw core::RunError("the front is stuck at the box around the points; try another --detail");
        complex.set_label(t, front.is_passed(t) ? outside_label : inside_label);
    }
}

}  // namespace dsc::reconstruct
