// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/workbench.h"

#include <algorithm>

#include "apps/reconstruct/front.h"
#include "dsc3d/deform/move_to_link.h"

namespace dsc::reconstruct {

namespace {

dsc3d::DeformParameters deformation(double edge_length, const WorkbenchParameters& own) {
    dsc3d::DeformParameters parameters;
    parameters.edge_length = edge_length;
    parameters.poor_quality = own.poor_quality;
    parameters.bad_quality = own.poor_quality;
    parameters.stopping_quality = own.least_quality;
    parameters.upkeep_rounds = 3;
    return parameters;
}

}  // namespace

Workbench::Workbench(dsc3d::Mesh& mesh, double edge_length, const WorkbenchParameters& parameters)
    : mesh_(mesh),
      own_(parameters),
      parameters_(deformation(edge_length, parameters)),
      rated_(mesh, geometry::QualityMeasure::minimum_sine, dsc3d::FlatSurface::flat_boundary(mesh)),
      length_(mesh, edge_length, parameters_.growth),
      way_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      pull_(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
      advance_(mesh),
      upkeep_(rated_, parameters_.seed) {}

std::vector<VertexId> Workbench::interface_vertices() const {
    std::vector<VertexId> result;
    for (std::uint32_t i = 0; i < complex().vertex_capacity(); ++i)
        if (!complex().is_deleted(VertexId(i)) && complex().is_interface(VertexId(i))) result.emplace_back(i);
    return result;
}

std::vector<EdgeId> Workbench::interface_edges() const {
    std::vector<EdgeId> result;
    for (std::uint32_t i = 0; i < complex().edge_capacity(); ++i) {
        const EdgeId e(i);
        if (!complex().is_deleted(e) && complex().is_interface(e)) result.push_back(e);
    }
    return result;
}

void Workbench::gather_ring(VertexId v, std::vector<std::array<VertexId, 2>>& triangles) {
    triangles.clear();
    for (const dsc3d::TetId t : rated_.walker().star(v)) {
        if (complex().label(t) != inside_label) continue;
        const dsc3d::TetVertices& corners = complex().vertices(t);
        for (int k = 0; k < 4; ++k) {
            if (corners[static_cast<std::size_t>(k)] == v) continue;
            const dsc3d::TetId next = complex().neighbour(t, k);
            if (!next.is_valid() || complex().label(next) == inside_label) continue;
            const dsc3d::FaceVertices face = complex().oriented_face(t, k);
            const std::size_t at = face[0] == v ? 0 : face[1] == v ? 1 : 2;
            triangles.push_back({face[(at + 1) % 3], face[(at + 2) % 3]});
        }
    }
}

bool Workbench::opposite(EdgeId e, std::array<VertexId, 2>& ends, std::array<VertexId, 2>& others) {
    if (complex().is_deleted(e) || !complex().is_interface(e) || complex().surface_degree(e) != 2) return false;
    dsc3d::gather_ring(complex(), e, ring_);
    ends = {ring_.a, ring_.b};
    const std::size_t n = ring_.tets.size();
    for (std::size_t i = 0; i < n; ++i) {
        const int here = complex().label(ring_.tets[i]), before = complex().label(ring_.tets[(i + n - 1) % n]);
        if (here == before) continue;
        // Tetrahedron i is [a b link[i] link[i + 1]], positive: seen against the turn, the triangle (a, b, link[i]) has
        // it behind.
        others[here == inside_label ? 1 : 0] = ring_.link[i];
    }
    return true;
}

std::size_t Workbench::move(std::span<const VertexId> vertices, const core::Attribute<VertexId, Point3>& target) {
    advance_.run(rated_, vertices, target, {.least_quality = own_.least_quality, .carried_rings = 2});
    region_.add(advance_.region());
    std::size_t arrived = 0;
    for (const VertexId v : vertices) {
        const bool is_there =
            position(v) == target[v] ||
            dsc3d::move_to_link(rated_, v, target[v], {.least_quality = own_.least_quality, .approach = 0.9});
        arrived += is_there ? 1 : 0;
    }
    return arrived;
}

VertexId Workbench::split(EdgeId e, const Point3& place) {
    const auto [a, b] = complex().vertices(e);
    const VertexId m = rated_.split(e, place);
    if (!m.is_valid()) return m;
    length_.set(m, 0.5 * (length_.at(a) + length_.at(b)));
    region_.add_star(rated_, m);
    return m;
}

bool Workbench::collapse(EdgeId e, VertexId kept, const Point3& place) {
    if (!collapse_.collapse_at(rated_, e, kept, place, own_.least_quality)) return false;
    region_.add_star(rated_, kept);
    return true;
}

bool Workbench::flip(EdgeId e) {
    dsc3d::gather_ring(complex(), e, ring_);
    const double wanted = std::min(rated_.worst_quality(ring_.tets), own_.least_quality);
    const VertexId a = ring_.a, b = ring_.b;
    if (!removal_.propose_flip(rated_, e, proposal_, wanted) || !rated_.apply(proposal_)) return false;
    region_.add_star(rated_, a);
    region_.add_star(rated_, b);
    return true;
}

void Workbench::keep_up() {
    region_.settle(complex());
    dsc3d::PassContext context = this->context();
    upkeep_.run(context);
    region_.clear();
}

}  // namespace dsc::reconstruct
