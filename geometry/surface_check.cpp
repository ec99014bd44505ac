// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

#include "core/assert.h"
#include "core/disjoint_sets.h"
#include "geometry/predicates.h"

namespace dsc::geometry {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

bool names_vertex_twice(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Collinear in space is collinear in each of the coordinate planes.
bool is_collinear(const Point3& a, const Point3& b, const Point3& c) {
    for (int k = 0; k < 3; ++k) {
        const auto in_plane = [k](const Point3& p) { return Point2(p[k], p[(k + 1) % 3]); };
        if (orientation(in_plane(a), in_plane(b), in_plane(c)) != Sign::zero) return false;
    }
    return true;
}

// One side of a triangle.
struct HalfEdge {
    SurfaceEdge edge;
    std::array<std::uint32_t, 2> corners;  // of the triangle at the two vertices; corner k of triangle t is 3 t + k
    bool is_forward;                       // from the lower to the higher vertex

    bool operator<(const HalfEdge& other) const {
        return std::tie(edge, corners) < std::tie(other.edge, other.corners);
    }
};

HalfEdge half_edge(const Triangle& triangle, std::uint32_t index, std::uint32_t k) {
    const std::uint32_t next = (k + 1) % 3;
    const std::uint32_t from = triangle[k], to = triangle[next];
    const std::uint32_t at_from = 3 * index + k, at_to = 3 * index + next;
    if (from < to) return {{from, to}, {at_from, at_to}, true};
    return {{to, from}, {at_to, at_from}, false};
}

class SurfaceChecker {
public:
    explicit SurfaceChecker(const SurfaceData& surface) : surface_(surface) {
        DSC_ASSERT(surface.triangles.size() < (std::uint64_t{1} << 32) / 3);
        for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
            const Triangle& t = surface.triangles[i];
            DSC_ASSERT(std::ranges::all_of(t, [&](std::uint32_t v) { return v < surface.vertices.size(); }));
            if (!names_vertex_twice(t)) kept_.push_back(i);
        }
    }

    SurfaceCheck check() {
        find_degenerate_triangles();
        find_duplicated_triangles();
        const std::size_t edges = check_edges();
        count(edges);
        measure();
        return std::move(check_);
    }

private:
    const Point3& corner(std::uint32_t triangle, std::size_t k) const {
        return surface_.vertices[surface_.triangles[triangle][k]];
    }

    void find_degenerate_triangles() {
        for (std::uint32_t i = 0; i < surface_.triangles.size(); ++i) {
            if (is_collinear(corner(i, 0), corner(i, 1), corner(i, 2))) check_.degenerate_triangles.push_back(i);
        }
    }

    void find_duplicated_triangles() {
        std::vector<std::pair<Triangle, std::uint32_t>> sorted;
        sorted.reserve(kept_.size());
        for (const std::uint32_t i : kept_) {
            Triangle t = surface_.triangles[i];
            std::ranges::sort(t);
            sorted.emplace_back(t, i);
        }
        std::ranges::sort(sorted);
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            if (sorted[i].first == sorted[i - 1].first) check_.duplicated_triangles.push_back(sorted[i].second);
        }
        std::ranges::sort(check_.duplicated_triangles);
    }

    /// Returns the number of edges.
    std::size_t check_edges() {
        std::vector<HalfEdge> sides;
        sides.reserve(3 * kept_.size());
        for (const std::uint32_t i : kept_) {
            for (std::uint32_t k = 0; k < 3; ++k) sides.push_back(half_edge(surface_.triangles[i], i, k));
        }
        std::ranges::sort(sides, std::less());

        core::DisjointSets fans(3 * surface_.triangles.size());
        std::size_t edges = 0;
        for (auto first = sides.begin(); first != sides.end(); ++edges) {
            auto last = first + 1;
            for (; last != sides.end() && last->edge == first->edge; ++last) {
                fans.unite(first->corners[0], last->corners[0]);
                fans.unite(first->corners[1], last->corners[1]);
            }
            if (last - first == 1) check_.open_edges.push_back(first->edge);
            if (last - first == 2 && first->is_forward == first[1].is_forward) {
                check_.misoriented_edges.push_back(first->edge);
            }
            if (last - first > 2) check_.non_manifold_edges.push_back(first->edge);
            first = last;
        }
        find_non_manifold_vertices(fans);
        return edges;
    }

    void find_non_manifold_vertices(core::DisjointSets& fans) {
        std::vector<bool> has_fan(surface_.vertices.size());
        for (const std::uint32_t i : kept_) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                if (fans.find(3 * i + k) != 3 * i + k) continue;
                const std::uint32_t vertex = surface_.triangles[i][k];
                if (has_fan[vertex]) check_.non_manifold_vertices.push_back(vertex);
                has_fan[vertex] = true;
            }
        }
        std::vector<std::uint32_t>& vertices = check_.non_manifold_vertices;
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }

    void count(std::size_t edges) {
        core::DisjointSets connected(surface_.vertices.size());
        std::vector<bool> is_used(surface_.vertices.size());
        for (const std::uint32_t i : kept_) {
            const Triangle& t = surface_.triangles[i];
            connected.unite(t[0], t[1]);
            connected.unite(t[0], t[2]);
            for (const std::uint32_t v : t) is_used[v] = true;
        }
        std::int64_t vertices = 0;
        for (std::uint32_t v = 0; v < surface_.vertices.size(); ++v) {
            if (!is_used[v]) continue;
            ++vertices;
            if (connected.find(v) == v) ++check_.components;
        }
        check_.euler_characteristic =
            vertices - static_cast<std::int64_t>(edges) + static_cast<std::int64_t>(kept_.size());
        if (check_.is_closed() && check_.is_manifold() && check_.is_oriented()) {
            check_.genus = static_cast<std::int64_t>(check_.components) - check_.euler_characteristic / 2;
        }
    }

    // Seen from within the surface, so that the volume of a small one far from the origin is as accurate.
    void measure() {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t i : kept_) {
            for (std::size_t k = 0; k < 3; ++k) box.extend(corner(i, k));
        }
        double area = 0, volume = 0;
        for (const std::uint32_t i : kept_) {
            const Point3 a = corner(i, 0) - box.center();
            const Point3 normal = (corner(i, 1) - corner(i, 0)).cross(corner(i, 2) - corner(i, 0));
            area += normal.stableNorm() / 2;
            volume += a.dot(normal) / 6;
        }
        check_.area = area;
        if (check_.is_closed() && check_.is_oriented()) check_.volume = volume;
    }

    const SurfaceData& surface_;
    std::vector<std::uint32_t> kept_;  // the triangles of three different vertices
    SurfaceCheck check_;
};

}  // namespace

SurfaceCheck check_surface(const SurfaceData& surface) { return SurfaceChecker(surface).check(); }

}  // namespace dsc::geometry
