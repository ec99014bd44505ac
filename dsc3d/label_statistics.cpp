// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/label_statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "core/assert.h"
#include "core/disjoint_sets.h"
#include "dsc3d/complex/traversal.h"
#include "dsc3d/components.h"

namespace dsc::dsc3d {

namespace {

/// A face as it is seen from one of its tetrahedra.
struct FaceSide {
    FaceId face;
    std::uint32_t side;

    std::uint32_t index() const { return 2 * face.index() + side; }
};

class LabelCounter {
public:
    explicit LabelCounter(const Mesh& mesh)
        : mesh_(mesh),
          complex_(mesh.complex()),
          tets_(dsc3d::components(complex_)),
          sides_(2 * std::size_t{complex_.face_capacity()}),
          corners_(6 * std::size_t{complex_.face_capacity()}) {}

    std::vector<LabelStatistics> run() {
        measure();
        join_around_edges();
        count();
        std::vector<LabelStatistics> result;
        for (auto& [label, statistics] : labels_) {
            statistics.label = label;
            const std::int64_t euler = euler_[label];
            DSC_ASSERT(euler % 2 == 0);
            statistics.genus = statistics.surfaces - euler / 2;
            result.push_back(statistics);
        }
        return result;
    }

private:
    template <class Handle, class Use>
    void for_each(std::uint32_t capacity, Use&& use) const {
        for (std::uint32_t i = 0; i < capacity; ++i)
            if (!complex_.is_deleted(Handle(i))) use(Handle(i));
    }

    void measure() {
        for_each<TetId>(complex_.tet_capacity(), [&](TetId t) {
            const auto [a, b, c, d] = complex_.vertices(t);
            const Point3& p = mesh_.position(a);
            LabelStatistics& statistics = labels_[complex_.label(t)];
            ++statistics.tets;
            statistics.volume += (mesh_.position(b) - p).cross(mesh_.position(c) - p).dot(mesh_.position(d) - p) / 6;
        });
        for_each<FaceId>(complex_.face_capacity(), [&](FaceId f) {
            if (!complex_.is_surface(f)) return;
            const auto [a, b, c] = complex_.vertices(f);
            const Point3& p = mesh_.position(a);
            const double area = (mesh_.position(b) - p).cross(mesh_.position(c) - p).norm() / 2;
            for (const TetId t : complex_.tets(f)) {
                if (!t.is_valid()) continue;
                LabelStatistics& statistics = labels_[complex_.label(t)];
                (complex_.is_boundary(f) ? statistics.boundary_area : statistics.interface_area) += area;
            }
        });
    }

    // Around an edge the tetrahedra of one label between two surface faces hold these together: there the label's
    // surface has one edge.
    void join_around_edges() {
        EdgeRing ring;
        for_each<EdgeId>(complex_.edge_capacity(), [&](EdgeId e) {
            if (!complex_.is_surface(e)) return;
            gather_ring(complex_, e, ring);
            const std::size_t count = ring.tets.size();
            // In a closed ring the walk begins behind a surface face.
            std::size_t start = 0;
            while (ring.is_closed && !complex_.is_surface(face_between(ring, start))) ++start;
            FaceSide entry = {};
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t k = (start + i) % count;
                const TetId t = ring.tets[k];
                const FaceId before = face_of(ring, t, ring.link[k]), after = face_of(ring, t, ring.link[k + 1]);
                if (complex_.is_surface(before)) entry = side(before, t);
                if (complex_.is_surface(after)) join(entry, side(after, t), ring, complex_.label(t));
            }
        });
    }

    // The face of the edge and a vertex of its link, as one of t.
    FaceId face_of(const EdgeRing& ring, TetId t, VertexId link) const {
        const TetVertices& v = complex_.vertices(t);
        for (std::size_t i = 0; i < 4; ++i)
            if (v[i] != ring.a && v[i] != ring.b && v[i] != link) return complex_.faces(t)[i];
        DSC_ASSERT(false);
        return {};
    }
    FaceId face_between(const EdgeRing& ring, std::size_t i) const { return face_of(ring, ring.tets[i], ring.link[i]); }
    FaceSide side(FaceId f, TetId t) const { return {f, complex_.tets(f)[0] == t ? 0u : 1u}; }

    std::uint32_t corner(const FaceSide& side, VertexId v) const {
        const FaceVertices corners = complex_.vertices(side.face);
        return 3 * side.index() + static_cast<std::uint32_t>(std::ranges::find(corners, v) - corners.begin());
    }

    void join(const FaceSide& first, const FaceSide& second, const EdgeRing& ring, int label) {
        sides_.unite(first.index(), second.index());
        for (const VertexId v : {ring.a, ring.b}) corners_.unite(corner(first, v), corner(second, v));
        --euler_[label];
    }

    void count() {
        for_each<TetId>(complex_.tet_capacity(), [&](TetId t) {
            if (tets_.find(t.index()) == t.index()) ++labels_[complex_.label(t)].components;
        });
        for_each<FaceId>(complex_.face_capacity(), [&](FaceId f) {
            if (!complex_.is_surface(f)) return;
            for (std::uint32_t k = 0; k < 2; ++k) {
                const TetId t = complex_.tets(f)[k];
                if (!t.is_valid()) continue;
                const int label = complex_.label(t);
                const std::uint32_t index = FaceSide{f, k}.index();
                if (sides_.find(index) == index) ++labels_[label].surfaces;
                ++euler_[label];
                for (std::uint32_t i = 3 * index; i < 3 * index + 3; ++i)
                    if (corners_.find(i) == i) ++euler_[label];
            }
        });
    }

    const Mesh& mesh_;
    const Complex& complex_;
    core::DisjointSets tets_, sides_;
    core::DisjointSets corners_;  ///< of sides of faces: the vertices of the surfaces are their classes
    std::map<int, LabelStatistics> labels_;
    std::map<int, std::int64_t> euler_;  ///< of the surface of each label
};

}  // namespace

std::vector<LabelStatistics> label_statistics(const Mesh& mesh) { return LabelCounter(mesh).run(); }

}  // namespace dsc::dsc3d
