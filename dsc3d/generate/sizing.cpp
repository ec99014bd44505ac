// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/sizing.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dsc::dsc3d {

namespace {

using Cartesian = CGAL::Simple_cartesian<double>;
using SizedTriangles = std::vector<Cartesian::Triangle_3>;
using SizedPrimitive = CGAL::AABB_triangle_primitive<Cartesian, SizedTriangles::const_iterator>;

Cartesian::Point_3 point(const Point3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

struct Sizing::Tree {
    SizedTriangles triangles;
    CGAL::AABB_tree<CGAL::AABB_traits<Cartesian, SizedPrimitive>> tree;
};

Sizing::Sizing(const geometry::SurfaceData& surface, double growth) : tree_(std::make_unique<Tree>()), growth_(growth) {
    for (const auto& [a, b, c] : surface.triangles) {
        const Point3 &p = surface.vertices[a], &q = surface.vertices[b], &r = surface.vertices[c];
        tree_->triangles.emplace_back(point(p), point(q), point(r));
        edge_length_.push_back(((q - p).norm() + (r - q).norm() + (p - r).norm()) / 3);
    }
    least_ = *std::ranges::min_element(edge_length_);
    tree_->tree.rebuild(tree_->triangles.cbegin(), tree_->triangles.cend());
    tree_->tree.accelerate_distance_queries();
}

Sizing::~Sizing() = default;

Sizing::Answer Sizing::at(const Point3& p) const {
    const auto [place, triangle] = tree_->tree.closest_point_and_primitive(point(p));
    const double distance = std::sqrt(CGAL::squared_distance(place, point(p)));
    const double length = edge_length_[static_cast<std::size_t>(triangle - tree_->triangles.cbegin())];
    return {length + growth_ * std::max(0.0, distance - length), length, distance};
}

}  // namespace dsc::dsc3d
