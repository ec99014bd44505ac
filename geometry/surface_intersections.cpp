// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_intersections.h"

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>

#include "core/assert.h"

namespace dsc::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle = std::array<std::uint32_t, 3>;

class Box : public CGAL::Box_intersection_d::Box_d<double, 3> {
public:
    Box(const CGAL::Bbox_3& box, std::uint32_t index)
        : CGAL::Box_intersection_d::Box_d<double, 3>(box), triangle(index) {}

    std::uint32_t triangle;
};

class Intersector {
public:
    explicit Intersector(const SurfaceData& surface) : surface_(surface) {}

    Kernel::Triangle_3 triangle(std::uint32_t index) const {
        const Triangle& t = surface_.triangles[index];
        return {point(t[0]), point(t[1]), point(t[2])};
    }

    bool is_degenerate(std::uint32_t index) const {
        const Triangle& t = surface_.triangles[index];
        return CGAL::collinear(point(t[0]), point(t[1]), point(t[2]));
    }

    bool do_intersect(std::uint32_t first, std::uint32_t second) const {
        const Triangle s = common_vertices_first(first, second);
        const Triangle t = common_vertices_first(second, first);
        switch (common_vertices(first, second)) {
            case 0: return CGAL::do_intersect(triangle(first), triangle(second));
            case 1: return do_meet_beyond_vertex(first, s, second, t);
            case 2: return do_overlap_at_edge(s, t);
            default: return true;
        }
    }

private:
    Kernel::Point_3 point(std::uint32_t vertex) const {
        const Eigen::Vector3d& p = surface_.vertices[vertex];
        return {p.x(), p.y(), p.z()};
    }

    bool has_vertex(std::uint32_t triangle, std::uint32_t vertex) const {
        return std::ranges::find(surface_.triangles[triangle], vertex) != surface_.triangles[triangle].end();
    }

    std::ptrdiff_t common_vertices(std::uint32_t first, std::uint32_t second) const {
        return std::ranges::count_if(surface_.triangles[first],
                                     [&](std::uint32_t vertex) { return has_vertex(second, vertex); });
    }

    Triangle common_vertices_first(std::uint32_t triangle, std::uint32_t other) const {
        Triangle t = surface_.triangles[triangle];
        std::ranges::partition(t, [&](std::uint32_t vertex) { return has_vertex(other, vertex); });
        return t;
    }

    // What two triangles have in common beyond a vertex is convex and reaches the opposite side of one of them.
    bool do_meet_beyond_vertex(std::uint32_t first, const Triangle& s, std::uint32_t second, const Triangle& t) const {
        return CGAL::do_intersect(Kernel::Segment_3(point(s[1]), point(s[2])), triangle(second)) ||
               CGAL::do_intersect(Kernel::Segment_3(point(t[1]), point(t[2])), triangle(first));
    }

    // They do when they are folded onto each other.
    bool do_overlap_at_edge(const Triangle& s, const Triangle& t) const {
        const Kernel::Point_3 a = point(s[0]), b = point(s[1]), c = point(s[2]), d = point(t[2]);
        return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
    }

    const SurfaceData& surface_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 2>> self_intersections(const SurfaceData& surface) {
    const Intersector intersector(surface);
    std::vector<Box> boxes;
    boxes.reserve(surface.triangles.size());
    for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
        if (!intersector.is_degenerate(i)) boxes.emplace_back(intersector.triangle(i).bbox(), i);
    }
    std::vector<std::array<std::uint32_t, 2>> pairs;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        const auto [first, second] = std::minmax(a.triangle, b.triangle);
        if (intersector.do_intersect(first, second)) pairs.push_back({first, second});
    });
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace dsc::geometry
