// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/edge_collapse.h"

#include <algorithm>
#include <limits>

namespace dsc::dsc3d {

namespace {

VertexId other_end(const Complex& complex, EdgeId e, VertexId v) {
    const EdgeVertices& ends = complex.vertices(e);
    return ends[0] == v ? ends[1] : ends[0];
}

bool contains(const std::vector<VertexId>& sorted, VertexId v) {
    return std::binary_search(sorted.begin(), sorted.end(), v);
}

void intersect(std::vector<VertexId>& a, std::vector<VertexId>& b, std::vector<VertexId>& common) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    common.clear();
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
}

}  // namespace

bool EdgeCollapse::keeps_topology(const Complex& complex, EdgeId e, VertexId kept, StarWalker& walker) {
    const VertexId gone = other_end(complex, e, kept);
    if (!complex.is_surface(e) && complex.is_surface(kept) && complex.is_surface(gone)) return false;

    // Vertices: the common neighbours of the ends are the link of the edge.
    gather_ring(complex, e, ring_);
    link_ = ring_.link;
    if (ring_.is_closed) link_.pop_back();
    std::sort(link_.begin(), link_.end());
    const std::span<const TetId> star = walker.star(gone, around_gone_);
    star_of_gone_.assign(star.begin(), star.end());
    const std::span<const TetId> star_of_kept = walker.star(kept, around_kept_);
    intersect(around_kept_, around_gone_, common_);
    if (common_ != link_) return false;

    // Edges and faces: an edge xy or a face xyz that both ends see has to belong to the link of the edge too. With
    // x, y (and z) common neighbours, faces gone x y and kept x y, but no tetrahedron at the edge with x y.
    const auto is_in_ring = [&](VertexId x, VertexId y) {
        return std::any_of(ring_.tets.begin(), ring_.tets.end(),
                           [&](TetId t) { return complex.has_vertex(t, x) && complex.has_vertex(t, y); });
    };
    const auto sees = [&](VertexId x, VertexId y) {
        return std::any_of(star_of_kept.begin(), star_of_kept.end(),
                           [&](TetId t) { return complex.has_vertex(t, x) && complex.has_vertex(t, y); });
    };
    for (const TetId t : star_of_gone_) {
        if (complex.has_vertex(t, kept)) continue;
        std::array<VertexId, 3> shared;
        std::size_t count = 0;
        for (const VertexId v : complex.vertices(t))
            if (v != gone && contains(link_, v)) shared[count++] = v;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = i + 1; j < count; ++j)
                if (sees(shared[i], shared[j]) && !is_in_ring(shared[i], shared[j])) return false;
        if (count == 3 && std::any_of(star_of_kept.begin(), star_of_kept.end(), [&](TetId s) {
                return complex.has_vertex(s, shared[0]) && complex.has_vertex(s, shared[1]) &&
                       complex.has_vertex(s, shared[2]);
            }))
            return false;
    }
    return !complex.is_surface(e) || keeps_topology_of_surface(complex, e, kept, gone, star_of_kept);
}

// The same in the surface, coned off at its seams, and in the seams.
bool EdgeCollapse::keeps_topology_of_surface(const Complex& complex, EdgeId e, VertexId kept, VertexId gone,
                                             std::span<const TetId> star_of_kept) {
    const auto count_common = [](const auto& a, const auto& b, auto& common) {
        common.clear();
        std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
        return common.size();
    };
    surface_of_kept_.gather(complex, star_of_kept, kept);
    surface_of_gone_.gather(complex, star_of_gone_, gone);
    const std::uint32_t sheets = complex.surface_degree(e);
    if (count_common(surface_of_kept_.vertices(), surface_of_gone_.vertices(), common_) != sheets) return false;
    if (count_common(surface_of_kept_.edges(), surface_of_gone_.edges(), common_edges_) != 0) return false;
    if (!complex.is_interface(kept) || !complex.is_interface(gone)) return true;

    const SurfacePlace place_of_kept = surface_of_kept_.place(), place_of_gone = surface_of_gone_.place();
    if (sheets == 2) return place_of_kept == SurfacePlace::sheet || place_of_gone == SurfacePlace::sheet;
    if (place_of_kept == SurfacePlace::corner && place_of_gone == SurfacePlace::corner) return false;
    return count_common(surface_of_kept_.seams(), surface_of_gone_.seams(), common_) == 0;
}

bool EdgeCollapse::keeps_surface(const RatedMesh& mesh, EdgeId e, VertexId kept) {
    const Complex& complex = mesh.complex();
    switch (mesh.surface().motion(other_end(complex, e, kept))) {
        case VertexMotion::free: return true;
        case VertexMotion::plane: return complex.is_surface(e);
        case VertexMotion::line: return complex.is_surface(e) && mesh.surface().is_ridge(complex, e, ring_);
        case VertexMotion::fixed: break;
    }
    return false;
}

bool EdgeCollapse::propose(RatedMesh& mesh, EdgeId e, VertexId kept, double enough, Proposal& proposal) {
    const Complex& complex = mesh.complex();
    if (!keeps_surface(mesh, e, kept)) return false;
    const VertexId gone = other_end(complex, e, kept);
    proposal.clear();
    proposal.gone = gone;
    proposal.quality_after = std::numeric_limits<double>::infinity();
    // Most attempts would turn a tetrahedron over: they end at the first one.
    const std::span<const TetId> star = mesh.walker().star_while(gone, [&](TetId t) {
        if (complex.has_vertex(t, kept)) return true;
        for (const VertexId v : complex.vertices(t))
            if (v != gone && !mesh.allows_edge(kept, v)) return false;
        NewTet tet = {complex.vertices(t), complex.label(t)};
        tet.vertices[static_cast<std::size_t>(complex.index_of(t, gone))] = kept;
        proposal.quality_after = std::min(proposal.quality_after, mesh.rate(tet.vertices));
        proposal.added.push_back(tet);
        return proposal.quality_after > 0;
    });
    if (star.empty() || proposal.added.empty()) return false;
    proposal.quality_before = mesh.worst_quality(star);
    if (proposal.quality_after <= std::min(proposal.quality_before, enough)) return false;
    proposal.removed.assign(star.begin(), star.end());
    for (const TetId t : star) {
        const int place = complex.index_of(t, gone);
        if (mesh.surface().motion(gone) == VertexMotion::free) continue;
        for (int i = 0; i < 4; ++i) {
            const FaceId f = complex.faces(t)[static_cast<std::size_t>(i)];
            if (i == place || !complex.is_surface(f)) continue;
            FaceVertices face = complex.vertices(f);
            if (std::find(face.begin(), face.end(), kept) != face.end()) continue;
            // A sliver that lies flat on the surface: its face with `kept`, which stays, would become one of the
            // surface.
            if (complex.has_vertex(t, kept)) return false;
            std::replace(face.begin(), face.end(), gone, kept);
            const std::int32_t patch = mesh.surface().patch(f);
            for (const VertexId v : face)
                if (!mesh.surface().allows_edge(patch, mesh.position(v), mesh.position(kept))) return false;
            proposal.surface.push_back({face, patch});
        }
    }
    if (!proposal.surface.empty() && proposal.quality_after <= least_surface_quality) return false;
    return keeps_topology(complex, e, kept, mesh.walker());
}

bool EdgeCollapse::collapse_at(RatedMesh& mesh, EdgeId e, VertexId kept, const Point3& place, double enough) {
    const Complex& complex = mesh.complex();
    if (!keeps_topology(complex, e, kept, mesh.walker())) return false;
    const VertexId gone = other_end(complex, e, kept);
    proposal_.clear();
    proposal_.gone = gone;
    const std::span<const TetId> star_of_kept = mesh.walker().star(kept);
    proposal_.removed.assign(star_of_kept.begin(), star_of_kept.end());
    for (const TetId t : mesh.walker().star(gone))
        if (!complex.has_vertex(t, kept)) proposal_.removed.push_back(t);
    for (const TetId t : proposal_.removed) {
        if (complex.has_vertex(t, kept) && complex.has_vertex(t, gone)) continue;
        NewTet tet = {complex.vertices(t), complex.label(t)};
        if (complex.has_vertex(t, gone)) tet.vertices[static_cast<std::size_t>(complex.index_of(t, gone))] = kept;
        proposal_.added.push_back(tet);
    }
    if (!take_patches(mesh, kept, gone)) return false;
    const double least = std::min(mesh.worst_quality(proposal_.removed), enough);
    return mesh.apply_with(proposal_, kept, place, least);
}

// Of what is removed, but for the faces at the edge, and of what the vertex that is gone gives to the other one. False
// for a sliver that lies flat on the boundary: its face with `kept`, which stays, would become one of the boundary.
bool EdgeCollapse::take_patches(const RatedMesh& mesh, VertexId kept, VertexId gone) {
    const Complex& complex = mesh.complex();
    for (const TetId t : proposal_.removed) {
        for (const FaceId f : complex.faces(t)) {
            if (!mesh.surface().has_patch(complex, f)) continue;
            FaceVertices face = complex.vertices(f);
            const bool has_kept = std::find(face.begin(), face.end(), kept) != face.end();
            if (has_kept && std::find(face.begin(), face.end(), gone) != face.end()) continue;
            if (!has_kept && complex.has_vertex(t, kept) && std::find(face.begin(), face.end(), gone) != face.end())
                return false;
            std::replace(face.begin(), face.end(), gone, kept);
            proposal_.surface.push_back({face, mesh.surface().patch(f)});
        }
    }
    return true;
}

}  // namespace dsc::dsc3d
