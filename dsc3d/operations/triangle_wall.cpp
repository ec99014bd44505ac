// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/triangle_wall.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/disjoint_sets.h"
#include "core/errors.h"
#include "surface/features.h"

namespace dsc::dsc3d {

namespace {

using geometry::SurfaceData;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 kernel_point(const Point3& p) { return {p.x(), p.y(), p.z()}; }

// Of unit length at each vertex of the surface, weighted by the angles of the triangles there.
std::vector<Eigen::Vector3d> vertex_normals(const SurfaceData& surface) {
    std::vector<Eigen::Vector3d> normals(surface.vertices.size(), Eigen::Vector3d::Zero());
    for (const auto& triangle : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Point3& p = surface.vertices[triangle[k]];
            const Eigen::Vector3d a = surface.vertices[triangle[(k + 1) % 3]] - p;
            const Eigen::Vector3d b = surface.vertices[triangle[(k + 2) % 3]] - p;
            const Eigen::Vector3d scaled = a.cross(b);
            normals[triangle[k]] += std::atan2(scaled.norm(), a.dot(b)) * scaled.normalized();
        }
    for (Eigen::Vector3d& normal : normals) normal.normalize();
    return normals;
}

}  // namespace

class TriangleWall::Tree {
public:
    explicit Tree(const SurfaceData& surface) : surface_(surface), normals_(vertex_normals(surface)) {
        for (const auto& [a, b, c] : surface_.triangles)
            triangles_.emplace_back(kernel_point(surface_.vertices[a]), kernel_point(surface_.vertices[b]),
                                    kernel_point(surface_.vertices[c]));
        tree_.rebuild(triangles_.begin(), triangles_.end());
        tree_.accelerate_distance_queries();
    }

    Point3 nearest(const Point3& p) const {
        const Kernel::Point_3 q = tree_.closest_point(kernel_point(p));
        return {q.x(), q.y(), q.z()};
    }

    Eigen::Vector3d normal(const Point3& p) const {
        const auto [place, id] = tree_.closest_point_and_primitive(kernel_point(p));
        const auto& [a, b, c] = surface_.triangles[static_cast<std::size_t>(id - triangles_.begin())];
        const Point3 q(place.x(), place.y(), place.z());
        const auto area = [&](std::uint32_t u, std::uint32_t v) {
            return (surface_.vertices[u] - q).cross(surface_.vertices[v] - q).norm();
        };
        return (area(b, c) * normals_[a] + area(c, a) * normals_[b] + area(a, b) * normals_[c]).normalized();
    }

private:
    SurfaceData surface_;
    std::vector<Eigen::Vector3d> normals_;
    Triangles triangles_;
    AabbTree tree_;
};

TriangleWall::TriangleWall(const SurfaceData& surface) {
    if (surface.triangles.empty()) throw core::UsageError("a wall has to have triangles");
    tree_ = std::make_unique<const Tree>(surface);
}

TriangleWall::~TriangleWall() = default;

Point3 TriangleWall::nearest(const Point3& p) const { return tree_->nearest(p); }

Eigen::Vector3d TriangleWall::normal(const Point3& p) const { return tree_->normal(p); }

namespace {

/// The triangles on both sides of an edge, with the vertices opposite to it.
struct Sides {
    std::uint32_t first;
    std::uint32_t opposite;
};

core::DisjointSets smooth_pieces(const SurfaceData& surface, double feature_angle) {
    core::DisjointSets pieces(surface.triangles.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, Sides> open;
    for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
        const auto& triangle = surface.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
            const auto other = open.find({b, a});
            if (other == open.end()) {
                open[{a, b}] = {i, c};
                continue;
            }
            const auto& p = surface.vertices;
            if (!surface::is_feature_edge(p[a], p[b], p[c], p[other->second.opposite], feature_angle))
                pieces.unite(i, other->second.first);
            open.erase(other);
        }
    }
    return pieces;
}

SurfaceData part_of(const SurfaceData& surface, const std::vector<std::size_t>& triangles) {
    SurfaceData part;
    std::map<std::uint32_t, std::uint32_t> number;
    for (const std::size_t i : triangles) {
        auto& triangle = part.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = surface.triangles[i][k];
            const auto [entry, is_new] = number.emplace(v, static_cast<std::uint32_t>(part.vertices.size()));
            if (is_new) part.vertices.push_back(surface.vertices[v]);
            triangle[k] = entry->second;
        }
    }
    return part;
}

// All vertices within half the tolerance, a length, of the plane of the largest triangle: as FlatSurface takes them.
bool is_plane(const SurfaceData& surface, double tolerance) {
    Eigen::Vector3d largest = Eigen::Vector3d::Zero();
    Point3 point = surface.vertices.front();
    for (const auto& [a, b, c] : surface.triangles) {
        const Point3& p = surface.vertices[a];
        const Eigen::Vector3d scaled = (surface.vertices[b] - p).cross(surface.vertices[c] - p);
        if (scaled.squaredNorm() <= largest.squaredNorm()) continue;
        largest = scaled;
        point = p;
    }
    const Eigen::Vector3d normal = largest.normalized();
    return std::ranges::all_of(surface.vertices,
                               [&](const Point3& p) { return std::abs(normal.dot(p - point)) <= 0.5 * tolerance; });
}

}  // namespace

Walls container_walls(const SurfaceData& container, const ContainerParameters& parameters) {
    Eigen::AlignedBox3d box;
    for (const Point3& p : container.vertices) box.extend(p);
    core::DisjointSets pieces = smooth_pieces(container, parameters.feature_angle);
    std::map<std::uint32_t, std::vector<std::size_t>> triangles;
    for (std::uint32_t i = 0; i < container.triangles.size(); ++i) triangles[pieces.find(i)].push_back(i);
    Walls walls;
    for (const auto& [piece, members] : triangles) {
        const SurfaceData part = part_of(container, members);
        if (!is_plane(part, parameters.tolerance * box.diagonal().norm()))
            walls.push_back(std::make_shared<TriangleWall>(part));
    }
    return walls;
}

}  // namespace dsc::dsc3d
