// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/edge_removal.h"

#include <algorithm>
#include <limits>

#include "geometry/polygon_triangulation.h"

namespace dsc::dsc3d {

namespace {

// Where the link of a surface edge meets the surface, in a ring that begins at one of the two places.
std::size_t opposite_surface_vertex(const RatedMesh& mesh, const EdgeRing& ring) {
    for (std::size_t i = 1; i < ring.tets.size(); ++i)
        if (mesh.complex().label(ring.tets[i]) != mesh.complex().label(ring.tets[0])) return i;
    return ring.tets.size();
}

// Turns a closed ring so that it begins at an interface face.
void begin_at_interface(const Complex& complex, EdgeRing& ring) {
    const std::size_t n = ring.tets.size();
    std::size_t first = 0;
    while (complex.label(ring.tets[first]) == complex.label(ring.tets[(first + n - 1) % n])) ++first;
    std::rotate(ring.tets.begin(), ring.tets.begin() + static_cast<std::ptrdiff_t>(first), ring.tets.end());
    ring.link.pop_back();
    std::rotate(ring.link.begin(), ring.link.begin() + static_cast<std::ptrdiff_t>(first), ring.link.end());
    ring.link.push_back(ring.link.front());
}

}  // namespace

bool EdgeRemoval::propose(RatedMesh& mesh, EdgeId e, Proposal& proposal, std::optional<double> wanted) {
    const Complex& complex = mesh.complex();
    const bool is_surface = complex.is_surface(e);
    if (is_surface && complex.surface_degree(e) != 2) return false;
    gather_ring(complex, e, ring_);
    const std::size_t n = ring_.tets.size();
    if (n > static_cast<std::size_t>(max_ring)) return false;

    proposal.clear();
    proposal.removed = ring_.tets;
    proposal.quality_before = mesh.worst_quality(ring_.tets);
    proposal.quality_after = std::numeric_limits<double>::infinity();
    const double threshold = std::max(is_surface ? least_surface_quality : 0.0,
                                      wanted.value_or(proposal.quality_before + least_quality_gain));

    if (!is_surface) return n >= 3 && add_arc(mesh, 0, n, threshold, proposal);

    const std::int32_t patch = mesh.surface().flat_patch(complex, ring_);
    if (patch == FlatSurface::no_patch || !add_surface_arcs(mesh, threshold, proposal)) return false;
    if (!mesh.surface().allows_edge(patch, mesh.position(c_), mesh.position(d_))) return false;
    proposal.surface = {{{ring_.a, c_, d_}, patch}, {{ring_.b, c_, d_}, patch}};
    return true;
}

bool EdgeRemoval::propose_flip(RatedMesh& mesh, EdgeId e, Proposal& proposal, double wanted) {
    const Complex& complex = mesh.complex();
    if (complex.is_boundary(e) || complex.surface_degree(e) != 2) return false;
    gather_ring(complex, e, ring_);
    if (ring_.tets.size() > static_cast<std::size_t>(max_ring)) return false;
    proposal.clear();
    proposal.removed = ring_.tets;
    proposal.quality_before = mesh.worst_quality(ring_.tets);
    proposal.quality_after = std::numeric_limits<double>::infinity();
    return add_surface_arcs(mesh, std::max(wanted, least_surface_quality), proposal);
}

// The two parts of the ring of a surface edge, or the one on the boundary, with the edge cd between them.
bool EdgeRemoval::add_surface_arcs(RatedMesh& mesh, double threshold, Proposal& proposal) {
    const std::size_t n = ring_.tets.size();
    if (ring_.is_closed) begin_at_interface(mesh.complex(), ring_);
    const std::size_t middle = ring_.is_closed ? opposite_surface_vertex(mesh, ring_) : n;
    c_ = ring_.link[0];
    d_ = ring_.link[middle];
    if (middle < 2 || !add_arc(mesh, 0, middle + 1, threshold, proposal)) return false;
    if (ring_.is_closed && (n - middle < 2 || !add_arc(mesh, middle, n - middle + 1, threshold, proposal)))
        return false;
    // Where a surface is flat up to its tolerance, or bent, c and d can be joined already.
    return !mesh.walker().edge_between(c_, d_).is_valid();
}

// Triangulates the part of the link that begins at vertex `begin`; its first and last vertex are joined.
bool EdgeRemoval::add_arc(const RatedMesh& mesh, std::size_t begin, std::size_t vertices, double threshold,
                          Proposal& proposal) {
    const auto at = [&](int i) { return ring_.link[begin + static_cast<std::size_t>(i)]; };
    const VertexId a = ring_.a, b = ring_.b;
    const geometry::PolygonTriangulation<max_ring + 1> best(
        static_cast<int>(vertices), threshold, [&](int i, int j, int k) {
            const double above = mesh.rate(at(i), at(j), at(k), b);
            return above <= threshold ? above : std::min(above, mesh.rate(at(i), at(k), at(j), a));
        });
    if (!best.is_possible()) return false;
    proposal.quality_after = std::min(proposal.quality_after, best.value());
    const int label = mesh.complex().label(ring_.tets[begin]);
    best.for_each_triangle([&](int i, int j, int k) {
        proposal.added.push_back({{at(i), at(j), at(k), b}, label});
        proposal.added.push_back({{at(i), at(k), at(j), a}, label});
    });
    return true;
}

}  // namespace dsc::dsc3d
