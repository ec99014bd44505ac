// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/multi_face.h"

#include <algorithm>
#include <limits>

#include "geometry/polygon_triangulation.h"

namespace dsc::dsc3d {

void MultiFace::gather(const RatedMesh& mesh, FaceId f) {
    const Complex& complex = mesh.complex();
    const auto [above, below] = complex.tets(f);
    const int place = complex.index_of(above, f);
    const FaceVertices outwards = complex.oriented_face(above, place);
    a_ = complex.vertices(above)[static_cast<std::size_t>(place)];
    b_ = VertexId();
    label_above_ = label_below_ = complex.label(above);
    if (below.is_valid()) {
        b_ = complex.vertices(below)[static_cast<std::size_t>(complex.index_of(below, f))];
        label_below_ = complex.label(below);
    }
    is_surface_ = complex.is_surface(f);
    patch_ = mesh.surface().patch(f);
    faces_.clear();
    faces_.push_back({{outwards[0], outwards[2], outwards[1]}, above, below});
    for (std::size_t i = 0; i < faces_.size(); ++i) add_neighbours(mesh, i);
}

// The checks that nearly every face fails come first.
void MultiFace::add_neighbours(const RatedMesh& mesh, std::size_t i) {
    const Complex& complex = mesh.complex();
    for (std::size_t k = 0; k < 3 && faces_.size() < static_cast<std::size_t>(max_faces); ++k) {
        const VertexId behind = faces_[i].vertices[k];
        const VertexId x = faces_[i].vertices[(k + 1) % 3], y = faces_[i].vertices[(k + 2) % 3];
        const TetId above = complex.neighbour(faces_[i].above, complex.index_of(faces_[i].above, behind));
        if (!above.is_valid()) continue;
        VertexId w;
        for (const VertexId v : complex.vertices(above))
            if (v != a_ && v != x && v != y) w = v;
        if (w == b_) continue;  // the edge xy has three tetrahedra: the multi-face ends there
        TetId below;
        if (b_.is_valid()) {
            below = complex.neighbour(faces_[i].below, complex.index_of(faces_[i].below, behind));
            if (!below.is_valid() || !complex.has_vertex(below, w) || complex.label(below) != label_below_) continue;
        }
        if (complex.label(above) != label_above_) continue;
        const FaceId f = complex.faces(above)[static_cast<std::size_t>(complex.index_of(above, a_))];
        if (!b_.is_valid() && !complex.is_boundary(f)) continue;
        if (is_surface_ && (patch_ == FlatSurface::no_patch || mesh.surface().patch(f) != patch_)) continue;
        if (std::any_of(faces_.begin(), faces_.end(), [&](const Face& known) { return known.above == above; }))
            continue;
        faces_[i].next[k] = static_cast<int>(faces_.size());
        faces_.push_back({{y, x, w}, above, below});
    }
}

// Either the multi-face ends at this edge, and a tetrahedron at ab comes there, or it goes on and what is best beyond
// the other two edges of the next face decides.
void MultiFace::choose_beyond(const RatedMesh& mesh, Face& face, std::size_t edge) {
    face.best[edge] = mesh.rate(b_, a_, face.vertices[(edge + 1) % 3], face.vertices[(edge + 2) % 3]);
    if (face.next[edge] < 0) return;
    const Face& next = faces_[static_cast<std::size_t>(face.next[edge])];
    const double beyond = std::min(next.best[0], next.best[1]);
    face.goes_on[edge] = beyond > face.best[edge];
    face.best[edge] = std::max(beyond, face.best[edge]);
}

void MultiFace::collect(const Face& face, std::size_t edges, Proposal& proposal) const {
    proposal.removed.push_back(face.above);
    proposal.removed.push_back(face.below);
    for (std::size_t k = 0; k < edges; ++k) {
        if (face.goes_on[k]) {
            collect(faces_[static_cast<std::size_t>(face.next[k])], 2, proposal);
        } else {
            proposal.added.push_back({{b_, a_, face.vertices[(k + 1) % 3], face.vertices[(k + 2) % 3]}, label_above_});
        }
    }
}

bool MultiFace::propose_removal(const RatedMesh& mesh, Proposal& proposal, std::optional<double> wanted) {
    if (is_surface_) return false;
    // A face stands behind all that were entered from it.
    for (std::size_t i = faces_.size(); i-- > 0;)
        for (std::size_t k = 0; k < (i == 0 ? 3u : 2u); ++k) choose_beyond(mesh, faces_[i], k);
    const Face& root = faces_.front();
    const double after = *std::min_element(root.best.begin(), root.best.end());
    if (after <= 0) return false;
    proposal.clear();
    collect(root, 3, proposal);
    proposal.quality_before = mesh.worst_quality(proposal.removed);
    proposal.quality_after = after;
    return wanted ? after > *wanted : proposal.is_improvement();
}

// The edges that only one of the faces has make one loop around them, unless the multi-face is not a disc.
bool MultiFace::find_polygon() {
    std::array<std::pair<VertexId, VertexId>, max_faces + 2> rim;
    std::size_t count = 0;
    const std::size_t expected = faces_.size() + 2;
    for (const Face& face : faces_) {
        for (std::size_t k = 0; k < 3; ++k) {
            const VertexId x = face.vertices[(k + 1) % 3], y = face.vertices[(k + 2) % 3];
            const bool is_inner = std::any_of(faces_.begin(), faces_.end(), [&](const Face& other) {
                for (std::size_t m = 0; m < 3; ++m)
                    if (other.vertices[(m + 1) % 3] == y && other.vertices[(m + 2) % 3] == x) return true;
                return false;
            });
            if (is_inner) continue;
            if (count == expected) return false;
            rim[count++] = {x, y};
        }
    }
    if (count != expected) return false;
    polygon_.clear();
    VertexId at = rim[0].first;
    do {
        polygon_.push_back(at);
        const auto next = std::find_if(rim.begin(), rim.begin() + static_cast<std::ptrdiff_t>(count),
                                       [&](const auto& edge) { return edge.first == at; });
        if (next == rim.begin() + static_cast<std::ptrdiff_t>(count)) return false;
        at = next->second;
    } while (at != polygon_.front() && polygon_.size() < count);
    return at == polygon_.front() && polygon_.size() == count;
}

bool MultiFace::propose_retriangulation(RatedMesh& mesh, Proposal& proposal, std::optional<double> wanted) {
    if (faces_.size() < 2 || !find_polygon()) return false;
    proposal.clear();
    for (const Face& face : faces_) {
        proposal.removed.push_back(face.above);
        if (b_.is_valid()) proposal.removed.push_back(face.below);
    }
    proposal.quality_before = mesh.worst_quality(proposal.removed);
    const double threshold = std::max(is_surface_ ? least_surface_quality : 0.0,
                                      wanted.value_or(proposal.quality_before + least_quality_gain));
    const auto at = [&](int i) { return polygon_[static_cast<std::size_t>(i)]; };
    const geometry::PolygonTriangulation<max_faces + 2> best(
        static_cast<int>(polygon_.size()), threshold, [&](int i, int j, int k) {
            const double above = mesh.rate(at(i), at(j), at(k), a_);
            if (above <= threshold || !b_.is_valid()) return above;
            return std::min(above, mesh.rate(at(i), at(k), at(j), b_));
        });
    if (!best.is_possible()) return false;
    proposal.quality_after = best.value();
    bool is_simplicial = true;
    best.for_each_triangle([&](int i, int j, int k) {
        proposal.added.push_back({{at(i), at(j), at(k), a_}, label_above_});
        if (b_.is_valid()) proposal.added.push_back({{at(i), at(k), at(j), b_}, label_below_});
        if (!is_surface_) return;
        proposal.surface.push_back({{at(i), at(j), at(k)}, patch_});
        is_simplicial = is_simplicial && !joins_again(mesh, at(i), at(j)) && !joins_again(mesh, at(j), at(k)) &&
                        !joins_again(mesh, at(k), at(i));
    });
    return is_simplicial;
}

// Where a surface is flat up to its tolerance, x and y can be joined outside the multi-face already, along a ridge.
bool MultiFace::joins_again(RatedMesh& mesh, VertexId x, VertexId y) const {
    const bool is_side = std::any_of(faces_.begin(), faces_.end(), [&](const Face& face) {
        const auto has = [&](VertexId v) {
            return std::find(face.vertices.begin(), face.vertices.end(), v) != face.vertices.end();
        };
        return has(x) && has(y);
    });
    return !is_side && mesh.walker().edge_between(x, y).is_valid();
}

}  // namespace dsc::dsc3d
