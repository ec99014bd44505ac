// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/facing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dsc::dsc3d {

namespace {

double smallest_height(const PassContext& context, TetId t) {
    double largest = 0;
    for (const FaceId f : context.complex().faces(t)) {
        const FaceVertices v = context.complex().vertices(f);
        const Point3& a = context.mesh.position(v[0]);
        largest = std::max(largest, (context.mesh.position(v[1]) - a).cross(context.mesh.position(v[2]) - a).norm());
    }
    return 6 * context.volume(t) / largest;
}

// Of the interface of the region of the label at v, outwards; zero where it touches itself.
Eigen::Vector3d region_normal(PassContext& context, VertexId v, int label) {
    const Complex& complex = context.complex();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const TetId t : context.mesh.walker().star(v)) {
        if (complex.label(t) != label) continue;
        for (int i = 0; i < 4; ++i) {
            if (complex.vertices(t)[static_cast<std::size_t>(i)] == v) continue;
            const TetId next = complex.neighbour(t, i);
            if (!next.is_valid() || complex.label(next) == label) continue;
            const FaceVertices face = complex.oriented_face(t, i);
            const Point3& p = context.mesh.position(face[0]);
            sum += (context.mesh.position(face[1]) - p).cross(context.mesh.position(face[2]) - p);
        }
    }
    return sum.normalized();
}

std::optional<Facing> across_normals(PassContext& context, TetId t, double distance) {
    const Complex& complex = context.complex();
    const TetVertices corners = complex.vertices(t);
    const double near = distance * context.least_wanted_length(t);
    if (smallest_height(context, t) >= near) return std::nullopt;
    std::array<Eigen::Vector3d, 4> normals;
    for (std::size_t i = 0; i < 4; ++i) normals[i] = region_normal(context, corners[i], complex.label(t));
    std::optional<Facing> nearest;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            if (normals[i].dot(normals[j]) >= context.parameters.contact_cosine) continue;
            const Eigen::Vector3d across = context.mesh.position(corners[j]) - context.mesh.position(corners[i]);
            const double gap = std::max(-normals[i].dot(across), normals[j].dot(across));
            if (gap >= 0 && gap < (nearest ? nearest->gap : near)) nearest = {corners[i], corners[j], gap, across};
        }
    }
    return nearest;
}

// The shortest edge inside, or the longest edge of the narrowest face.
std::optional<Facing> waist(const PassContext& context, TetId t, double distance) {
    const Complex& complex = context.complex();
    const double near = distance * context.least_wanted_length(t);
    const double height = std::sqrt(3.0) / 2;  // of an equilateral triangle over its edge
    std::optional<Facing> narrowest;
    for (const EdgeId e : complex.edges(t)) {
        const auto [a, b] = complex.vertices(e);
        if (complex.is_surface(e)) continue;
        const double gap = context.length(e);
        if (gap < (narrowest ? narrowest->gap : context.parameters.waist_share * near))
            narrowest = {a, b, gap, context.mesh.position(b) - context.mesh.position(a)};
    }
    for (const FaceId f : complex.faces(t)) {
        if (complex.is_surface(f)) continue;
        EdgeId longest;
        for (const EdgeId e : complex.edges(f)) {
            if (!complex.is_interface(e)) {
                longest = EdgeId();
                break;
            }
            if (!longest.is_valid() || context.length(e) > context.length(longest)) longest = e;
        }
        if (!longest.is_valid()) continue;
        const double gap = height * context.length(longest);
        const auto [a, b] = complex.vertices(longest);
        if (gap < (narrowest ? narrowest->gap : near))
            narrowest = {a, b, gap, context.mesh.position(b) - context.mesh.position(a)};
    }
    return narrowest;
}

// Out of the domain, of the boundary face at v that looks most against the direction: at edges of the domain there are
// several walls.
Eigen::Vector3d wall_normal(PassContext& context, VertexId v, const Eigen::Vector3d& direction) {
    const Complex& complex = context.complex();
    Eigen::Vector3d most = Eigen::Vector3d::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (const TetId t : context.mesh.walker().star(v)) {
        for (int i = 0; i < 4; ++i) {
            const FaceVertices face = complex.oriented_face(t, i);
            if (std::find(face.begin(), face.end(), v) == face.end() || complex.neighbour(t, i).is_valid()) continue;
            const Point3& p = context.mesh.position(face[0]);
            const Eigen::Vector3d normal =
                (context.mesh.position(face[1]) - p).cross(context.mesh.position(face[2]) - p).normalized();
            if (normal.dot(direction) >= least) continue;
            least = normal.dot(direction);
            most = normal;
        }
    }
    return most;
}

std::optional<Facing> across_to_wall(PassContext& context, TetId t, double distance) {
    const Complex& complex = context.complex();
    const double near = distance * context.least_wanted_length(t);
    std::optional<Facing> nearest;
    for (const VertexId v : complex.vertices(t)) {
        if (complex.is_boundary(v)) continue;
        const Eigen::Vector3d normal = region_normal(context, v, complex.label(t));
        for (const VertexId w : complex.vertices(t)) {
            if (!complex.is_boundary(w)) continue;
            const Eigen::Vector3d out = wall_normal(context, w, normal);
            const Eigen::Vector3d across = context.mesh.position(w) - context.mesh.position(v);
            const double gap = std::max(out.dot(across), -normal.dot(across));
            if (gap >= (nearest ? nearest->gap : near)) continue;
            if (normal.dot(out) < context.parameters.wall_cosine) nearest = {v, w, gap, out};
        }
    }
    return nearest;
}

}  // namespace

std::optional<Facing> facing_sheets(PassContext& context, TetId t, double distance) {
    const Complex& complex = context.complex();
    const TetVertices& corners = complex.vertices(t);
    const auto is_surface = [&](VertexId v) { return complex.is_surface(v); };
    const auto is_interface = [&](VertexId v) { return complex.is_interface(v); };
    const auto is_inside = [&](VertexId v) { return !complex.is_boundary(v); };
    if (!std::all_of(corners.begin(), corners.end(), is_surface)) return std::nullopt;
    if (std::none_of(corners.begin(), corners.end(), is_inside)) return std::nullopt;
    if (!std::all_of(corners.begin(), corners.end(), is_inside))
        if (const std::optional<Facing> wall = across_to_wall(context, t, distance)) return wall;
    if (!std::all_of(corners.begin(), corners.end(), is_interface)) return std::nullopt;
    const std::optional<Facing> across = across_normals(context, t, distance);
    return across ? across : waist(context, t, distance);
}

bool is_closing(const PassContext& context, const Facing& facing) {
    const Eigen::Vector3d &a = context.way[facing.a], &b = context.way[facing.b];
    // Sheets that go together differ in their ways by the rounding of their positions.
    constexpr double rounding = 1e-9;
    return (b - a).dot(facing.across) < -rounding * (a.norm() + b.norm()) * facing.across.norm();
}

}  // namespace dsc::dsc3d
