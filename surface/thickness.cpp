// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/thickness.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <limits>

#include "surface/triangle.h"
#include "surface/vertex_quadric.h"
#include "surface/vertex_rings.h"

namespace dsc::surface {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr double infinite = std::numeric_limits<double>::infinity();

Kernel::Point_3 kernel_point(const Point3& p) { return {p.x(), p.y(), p.z()}; }

class Interior {
public:
    explicit Interior(const geometry::SurfaceData& surface) : surface_(surface) {
        for (const auto& t : surface.triangles) {
            const Point3 &a = surface.vertices[t[0]], &b = surface.vertices[t[1]], &c = surface.vertices[t[2]];
            normals_.push_back(unit_normal(a, b, c));
            triangles_.emplace_back(kernel_point(a), kernel_point(b), kernel_point(c));
        }
        tree_.rebuild(triangles_.begin(), triangles_.end());
    }

    double thickness(std::uint32_t v, const Vector3& inwards) const {
        const Point3& start = surface_.vertices[v];
        const Kernel::Ray_3 ray(kernel_point(start), Kernel::Vector_3(inwards.x(), inwards.y(), inwards.z()));
        const auto is_no_exit = [&](const Primitive::Id& id) {
            const auto t = number(id);
            return std::ranges::find(surface_.triangles[t], v) != surface_.triangles[t].end() ||
                   normals_[t].dot(inwards) <= 0;
        };
        const auto exit = tree_.first_intersected_primitive(ray, is_no_exit);
        // A tree of one triangle does not ask whether it is to be skipped.
        if (!exit || is_no_exit(*exit)) return infinite;
        const std::size_t t = number(*exit);
        return std::abs(normals_[t].dot(surface_.vertices[surface_.triangles[t][0]] - start));
    }

private:
    std::size_t number(const Primitive::Id& id) const { return static_cast<std::size_t>(id - triangles_.begin()); }

    const geometry::SurfaceData& surface_;
    std::vector<Vector3> normals_;
    Triangles triangles_;
    Tree tree_;
};

}  // namespace

std::vector<double> thickness(const geometry::SurfaceData& surface) {
    std::vector<double> result(surface.vertices.size(), infinite);
    if (surface.triangles.empty()) return result;
    const Interior interior(surface);
    const VertexRings rings(surface);
    std::vector<RingTriangle> buffer;
    for (std::uint32_t v = 0; v < result.size(); ++v) {
        const Vector3 normal = vertex_quadric(rings.ring(v, buffer)).mean_normal;
        if (!normal.isZero(0)) result[v] = interior.thickness(v, -normal.normalized());
    }
    return result;
}

}  // namespace dsc::surface
