// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/remesh.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/errors.h"
#include "core/require.h"
#include "geometry/surface_check.h"
#include "geometry/surface_intersections.h"

namespace dsc::dsc3d {

using geometry::SurfaceData;

namespace {

using Cartesian = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Cartesian::Point_3>;
using EdgeFlags = SurfaceMesh::Property_map<SurfaceMesh::Edge_index, bool>;
using VertexFlags = SurfaceMesh::Property_map<SurfaceMesh::Vertex_index, bool>;

constexpr double max_triangles = 1e7;

double area(const SurfaceData& surface) {
    double sum = 0;
    for (const auto& [a, b, c] : surface.triangles) {
        const Eigen::Vector3d& p = surface.vertices[a];
        sum += (surface.vertices[b] - p).cross(surface.vertices[c] - p).norm() / 2;
    }
    return sum;
}

SurfaceMesh surface_mesh(const SurfaceData& surface) {
    SurfaceMesh mesh;
    std::vector<std::optional<SurfaceMesh::Vertex_index>> vertices(surface.vertices.size());
    for (const auto& triangle : surface.triangles) {
        std::array<SurfaceMesh::Vertex_index, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            std::optional<SurfaceMesh::Vertex_index>& v = vertices[triangle[k]];
            const Eigen::Vector3d& p = surface.vertices[triangle[k]];
            if (!v) v = mesh.add_vertex({p.x(), p.y(), p.z()});
            corners[k] = *v;
        }
        mesh.add_face(corners[0], corners[1], corners[2]);
    }
    return mesh;
}

SurfaceData surface_data(const SurfaceMesh& mesh) {
    SurfaceData surface;
    std::vector<std::uint32_t> number(mesh.num_vertices() + mesh.number_of_removed_vertices());
    for (const auto v : mesh.vertices()) {
        number[v] = static_cast<std::uint32_t>(surface.vertices.size());
        const Cartesian::Point_3& p = mesh.point(v);
        surface.vertices.emplace_back(p.x(), p.y(), p.z());
    }
    for (const auto f : mesh.faces()) {
        std::array<std::uint32_t, 3>& corners = surface.triangles.emplace_back();
        std::size_t k = 0;
        for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners[k++] = number[v];
    }
    return surface;
}

// Where sharp edges end, meet or turn.
void mark_corners(const SurfaceMesh& mesh, const EdgeFlags& is_sharp, double angle, VertexFlags& is_corner) {
    for (const auto v : mesh.vertices()) {
        std::vector<Cartesian::Vector_3> directions;
        for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
            if (is_sharp[mesh.edge(h)]) directions.push_back(mesh.point(mesh.source(h)) - mesh.point(v));
        if (directions.empty()) continue;
        is_corner[v] = directions.size() != 2;
        if (directions.size() != 2) continue;
        const double cosine =
            directions[0] * directions[1] / std::sqrt(directions[0].squared_length() * directions[1].squared_length());
        is_corner[v] = cosine > -std::cos(angle * std::numbers::pi / 180);
    }
}

}  // namespace

void RemeshParameters::validate() const {
    core::require(edge_length > 0 && std::isfinite(edge_length), "edge_length: has to be positive");
    core::require(feature_angle > 0 && feature_angle <= 180, "feature_angle: has to be in (0, 180]");
    core::require(iterations >= 1, "iterations: has to be at least 1");
}

SurfaceData remeshed(const SurfaceData& surface, const RemeshParameters& parameters) {
    namespace pmp = CGAL::Polygon_mesh_processing;
    parameters.validate();
    const geometry::SurfaceCheck check = geometry::check_surface(surface);
    core::require(check.degenerate_triangles.empty() && check.is_closed() && check.is_manifold() && check.is_oriented(),
                  "the surface to be remeshed is not a closed, oriented manifold of proper triangles");
    core::require(area(surface) <= max_triangles * std::sqrt(3.0) / 4 * parameters.edge_length * parameters.edge_length,
                  "edge_length: that would be more than 1e7 triangles");
    SurfaceMesh mesh = surface_mesh(surface);
    EdgeFlags is_sharp = mesh.add_property_map<SurfaceMesh::Edge_index, bool>("e:is_sharp", false).first;
    VertexFlags is_corner = mesh.add_property_map<SurfaceMesh::Vertex_index, bool>("v:is_corner", false).first;
    pmp::detect_sharp_edges(mesh, parameters.feature_angle, is_sharp);
    mark_corners(mesh, is_sharp, parameters.feature_angle, is_corner);
    pmp::isotropic_remeshing(mesh.faces(), parameters.edge_length, mesh,
                             pmp::parameters::number_of_iterations(static_cast<unsigned>(parameters.iterations))
                                 .edge_is_constrained_map(is_sharp)
                                 .vertex_is_constrained_map(is_corner)
                                 .protect_constraints(false)
                                 .collapse_constraints(true)
                                 .relax_constraints(false));
    SurfaceData result = surface_data(mesh);
    if (result.triangles.empty() || !geometry::self_intersections(result).empty())
        throw core::RunError(
            "the remeshed surface meets itself: its edges are too long for its thin parts, or too many of them are "
            "taken for sharp; "
            "try a smaller edge length or a larger feature angle");
    return result;
}

}  // namespace dsc::dsc3d
