// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/flat_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace dsc::dsc3d {

namespace {

double bounding_box_diagonal(const Mesh& mesh) {
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = 0; i < mesh.complex().vertex_capacity(); ++i)
        if (!mesh.complex().is_deleted(VertexId(i))) box.extend(mesh.position(VertexId(i)));
    return box.diagonal().norm();
}

}  // namespace

class FlatSurface::Builder {
public:
    Builder(FlatSurface& surface, const Mesh& mesh, const FlatSurfaceParameters& parameters)
        : surface_(surface),
          mesh_(mesh),
          complex_(mesh.complex()),
          half_tolerance_(0.5 * parameters.tolerance * bounding_box_diagonal(mesh)),
          least_cosine_(std::cos(parameters.feature_angle * std::numbers::pi / 180)) {
        surface_.half_tolerance_ = half_tolerance_;
    }

    void fix_everything() {
        for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i) {
            const FaceId f(i);
            if (!complex_.is_deleted(f) && complex_.is_surface(f)) new_patch(f);
        }
        for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (!complex_.is_deleted(v) && complex_.is_surface(v)) surface_.freedom_[v].motion = VertexMotion::fixed;
        }
    }

    // One patch for each wall.
    void take_walls() {
        for (const std::shared_ptr<const Wall>& wall : surface_.walls_)
            surface_.patches_.push_back({Point3::Zero(), Eigen::Vector3d::Zero(), wall.get()});
        if (surface_.walls_.empty()) return;
        for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i) {
            const FaceId f(i);
            if (!complex_.is_deleted(f) && complex_.is_boundary(f)) surface_.patch_[f] = wall_of(f);
        }
    }

    void find_patches() {
        // From large faces to small ones: a large face gives the better plane.
        std::vector<std::pair<double, FaceId>> seeds;
        for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i) {
            const FaceId f(i);
            if (!complex_.is_deleted(f) && surface_.has_patch(complex_, f)) seeds.emplace_back(-normal(f).norm(), f);
        }
        std::sort(seeds.begin(), seeds.end());
        for (const auto& [negative_area, seed] : seeds)
            if (surface_.patch_[seed] == no_patch) grow(seed);
    }

    void classify_vertices() {
        std::vector<std::vector<EdgeId>> ridges(complex_.vertex_capacity());
        for (std::uint32_t i = 0; i < complex_.edge_capacity(); ++i) {
            const EdgeId e(i);
            if (complex_.is_deleted(e) || !complex_.is_surface(e) || !is_ridge(e)) continue;
            for (const VertexId v : complex_.vertices(e)) ridges[v.index()].push_back(e);
        }
        StarWalker walker(complex_);
        for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (complex_.is_deleted(v) || !complex_.is_surface(v)) continue;
            surface_.freedom_[v].motion = VertexMotion::fixed;
            if (!ridges[i].empty()) continue;
            if (const std::optional<std::int32_t> patch = only_patch(walker.star(v), v)) {
                surface_.freedom_[v] = {VertexMotion::plane, *patch};
            }
        }
        find_lines(ridges);
    }

private:
    Eigen::Vector3d normal(FaceId f) const {
        // Of the side on which its first tetrahedron lies.
        const TetId t = complex_.tets(f)[0];
        const FaceVertices v = complex_.oriented_face(t, complex_.index_of(t, f));
        const Point3& a = mesh_.position(v[0]);
        return (mesh_.position(v[1]) - a).cross(mesh_.position(v[2]) - a);
    }

    // The patch of the wall on which its corners lie and along which it lies. At sharp edges they may lie on several:
    // then the one that is nearest to its middle.
    std::int32_t wall_of(FaceId f) const {
        const FaceVertices corners = complex_.vertices(f);
        const Point3 middle =
            (mesh_.position(corners[0]) + mesh_.position(corners[1]) + mesh_.position(corners[2])) / 3;
        const Eigen::Vector3d along = normal(f).normalized();
        std::int32_t nearest = no_patch;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < surface_.walls_.size(); ++i) {
            const Wall& wall = *surface_.walls_[i];
            const auto distance = [&](const Point3& p) { return (wall.nearest(p) - p).norm(); };
            const auto is_on_wall = [&](VertexId v) { return distance(mesh_.position(v)) <= half_tolerance_; };
            if (!std::all_of(corners.begin(), corners.end(), is_on_wall)) continue;
            if (std::abs(along.dot(wall.normal(middle))) < least_cosine_ || distance(middle) >= least) continue;
            nearest = static_cast<std::int32_t>(i);
            least = distance(middle);
        }
        return nearest;
    }

    std::int32_t new_patch(FaceId seed) {
        const auto patch = static_cast<std::int32_t>(surface_.patches_.size());
        surface_.patches_.push_back({mesh_.position(complex_.vertices(seed)[0]), normal(seed).normalized()});
        surface_.patch_[seed] = patch;
        return patch;
    }

    // Labels below and above a face, as seen along the normal of the patch: a patch separates the same two regions.
    std::pair<int, int> sides(FaceId f, const Eigen::Vector3d& patch_normal) const {
        const auto [first, second] = complex_.tets(f);
        const int inner = complex_.label(first);
        const int outer = second.is_valid() ? complex_.label(second) : inner;
        return normal(f).dot(patch_normal) > 0 ? std::pair(inner, outer) : std::pair(outer, inner);
    }

    void grow(FaceId seed) {
        const std::int32_t patch = new_patch(seed);
        const Patch plane = surface_.patches_.back();
        const std::pair<int, int> labels = sides(seed, plane.normal);
        front_ = {seed};
        while (!front_.empty()) {
            const FaceId f = front_.back();
            front_.pop_back();
            for (const EdgeId e : complex_.edges(f)) {
                const FaceId next = next_face(e, f);
                if (!next.is_valid()) continue;
                if (surface_.patch_[next] != no_patch || complex_.is_boundary(next) != complex_.is_boundary(f))
                    continue;
                if (!lies_in(plane, next) || is_bent(f, next, plane.normal)) continue;
                // Labels behind the boundary change while its planes stay.
                if (surface_.kind_ == Kind::flat && sides(next, plane.normal) != labels) continue;
                surface_.patch_[next] = patch;
                front_.push_back(next);
            }
        }
    }

    // Where interfaces have no patches, they don't part those of the boundary either.
    bool is_ridge(EdgeId e) {
        if (surface_.kind_ == Kind::flat) return surface_.is_ridge(complex_, e, ring_);
        if (!complex_.is_boundary(e)) return false;
        const std::array<FaceId, 2> sides = boundary_faces(e);
        return surface_.patch_[sides[0]] != surface_.patch_[sides[1]];
    }

    std::array<FaceId, 2> boundary_faces(EdgeId e) {
        gather_ring(complex_, e, ring_);
        const TetId first = ring_.tets.front(), last = ring_.tets.back();
        const std::size_t n = ring_.tets.size();
        return {complex_.faces(first)[static_cast<std::size_t>(complex_.index_of(first, ring_.link[1]))],
                complex_.faces(last)[static_cast<std::size_t>(complex_.index_of(last, ring_.link[n - 1]))]};
    }

    // The face that goes on behind e, if there is just one.
    FaceId next_face(EdgeId e, FaceId f) {
        if (surface_.kind_ == Kind::flat_boundary) {
            const std::array<FaceId, 2> sides = boundary_faces(e);
            return sides[0] == f ? sides[1] : sides[0];
        }
        if (complex_.surface_degree(e) != 2) return {};
        gather_ring(complex_, e, ring_);
        FaceId other;
        for (const TetId t : ring_.tets) {
            for (const FaceId g : complex_.faces(t)) {
                if (g == f || !complex_.is_surface(g)) continue;
                const std::array<EdgeId, 3>& edges = complex_.edges(g);
                if (std::find(edges.begin(), edges.end(), e) != edges.end()) other = g;
            }
        }
        return other;
    }

    bool lies_in(const Patch& plane, FaceId f) const {
        for (const VertexId v : complex_.vertices(f))
            if (std::abs(plane.normal.dot(mesh_.position(v) - plane.point)) > half_tolerance_) return false;
        return true;
    }

    // Between the normals of two neighbours, both turned to the side of the patch.
    bool is_bent(FaceId f, FaceId g, const Eigen::Vector3d& patch_normal) const {
        Eigen::Vector3d m = normal(f).normalized(), n = normal(g).normalized();
        if (m.dot(patch_normal) < 0) m = -m;
        // The first tetrahedra of two boundary faces lie on one side; those of interface faces may lie on either.
        if (complex_.is_interface(g) && n.dot(patch_normal) < 0) n = -n;
        return m.dot(n) < least_cosine_ || n.dot(patch_normal) < 0.5;
    }

    std::optional<std::int32_t> only_patch(std::span<const TetId> star, VertexId v) const {
        std::optional<std::int32_t> patch;
        for (const TetId t : star) {
            for (int i = 0; i < 4; ++i) {
                const FaceId f = complex_.faces(t)[static_cast<std::size_t>(i)];
                if (complex_.vertices(t)[static_cast<std::size_t>(i)] == v || !surface_.has_patch(complex_, f))
                    continue;
                if (patch && *patch != surface_.patch_[f]) return std::nullopt;
                patch = surface_.patch_[f];
            }
        }
        return patch;
    }

    VertexId other_end(EdgeId e, VertexId v) const {
        const EdgeVertices& ends = complex_.vertices(e);
        return ends[0] == v ? ends[1] : ends[0];
    }

    // Chains of ridge edges, cut where they branch or bend; what lies strictly inside a straight piece slides on it.
    void find_lines(const std::vector<std::vector<EdgeId>>& ridges) {
        std::vector<std::uint8_t> is_done(complex_.edge_capacity(), 0);
        const auto walk_from = [&](VertexId start, EdgeId e) {
            std::vector<VertexId> chain = {start};
            VertexId v = start;
            while (is_done[e.index()] == 0) {
                is_done[e.index()] = 1;
                v = other_end(e, v);
                chain.push_back(v);
                if (ridges[v.index()].size() != 2) break;
                e = ridges[v.index()][0] == e ? ridges[v.index()][1] : ridges[v.index()][0];
            }
            cut_into_lines(chain);
        };
        // Chains with ends first; what is left are loops.
        for (const bool takes_loops : {false, true}) {
            for (std::uint32_t i = 0; i < ridges.size(); ++i) {
                if (!takes_loops && ridges[i].size() == 2) continue;
                for (const EdgeId e : ridges[i])
                    if (is_done[e.index()] == 0) walk_from(VertexId(i), e);
            }
        }
    }

    void cut_into_lines(const std::vector<VertexId>& chain) {
        std::size_t begin = 0;
        while (begin + 2 < chain.size()) {
            std::size_t end = begin + 1;
            while (end + 1 < chain.size() && is_straight(chain, begin, end + 1)) ++end;
            if (end > begin + 1) add_line(chain, begin, end);
            begin = end;
        }
    }

    bool is_straight(const std::vector<VertexId>& chain, std::size_t begin, std::size_t end) const {
        const Point3& start = mesh_.position(chain[begin]);
        const Eigen::Vector3d span = mesh_.position(chain[end]) - start;
        if (span.norm() == 0) return false;
        const Eigen::Vector3d direction = span.normalized();
        double last = 0;
        for (std::size_t i = begin + 1; i < end; ++i) {
            const Eigen::Vector3d from_start = mesh_.position(chain[i]) - start;
            const double along = direction.dot(from_start);
            if (along <= last || along >= span.norm()) return false;
            if ((from_start - along * direction).norm() > half_tolerance_) return false;
            last = along;
        }
        return true;
    }

    void add_line(const std::vector<VertexId>& chain, std::size_t begin, std::size_t end) {
        const Point3& start = mesh_.position(chain[begin]);
        const auto line = static_cast<std::int32_t>(surface_.lines_.size());
        surface_.lines_.push_back({start, (mesh_.position(chain[end]) - start).normalized()});
        for (std::size_t i = begin + 1; i < end; ++i) {
            surface_.freedom_[chain[i]] = {VertexMotion::line, line};
        }
    }

    FlatSurface& surface_;
    const Mesh& mesh_;
    const Complex& complex_;
    double half_tolerance_;
    double least_cosine_;
    EdgeRing ring_;
    std::vector<FaceId> front_;
};

FlatSurface::FlatSurface(const Mesh& mesh, const FlatSurfaceParameters& parameters)
    : patch_(mesh.complex().face_attributes(), no_patch), freedom_(mesh.complex().vertex_attributes()) {
    Builder builder(*this, mesh, parameters);
    if (parameters.may_change) {
        builder.find_patches();
        builder.classify_vertices();
    } else {
        builder.fix_everything();
    }
}

FlatSurface::FlatSurface(const Mesh& mesh, Kind kind, Walls walls)
    : patch_(mesh.complex().face_attributes(), no_patch),
      freedom_(mesh.complex().vertex_attributes()),
      walls_(std::move(walls)),
      kind_(kind),
      mesh_(&mesh) {}

FlatSurface FlatSurface::rigid(const Mesh& mesh) { return FlatSurface(mesh, Kind::rigid, {}); }

FlatSurface FlatSurface::flat_boundary(const Mesh& mesh, Walls walls) {
    FlatSurface surface(mesh, Kind::flat_boundary, std::move(walls));
    Builder builder(surface, mesh, {});
    builder.take_walls();
    builder.find_patches();
    builder.classify_vertices();
    return surface;
}

FlatSurface::Freedom FlatSurface::freedom_between(const std::array<Point3, 2>& places,
                                                  const std::array<Freedom, 2>& freedoms,
                                                  const std::array<std::int32_t, 2>& patches) {
    if (patches[0] == patches[1]) return {VertexMotion::plane, patches[0]};
    // A vertex of a line has no other ridge.
    for (const Freedom& freedom : freedoms)
        if (freedom.motion == VertexMotion::line) return freedom;
    lines_.push_back({places[0], (places[1] - places[0]).normalized()});
    return {VertexMotion::line, static_cast<std::int32_t>(lines_.size()) - 1};
}

Eigen::Vector3d FlatSurface::allowed(VertexId v, const Eigen::Vector3d& step) const {
    return allowed({motion(v), freedom_[v].carrier}, v, step);
}

Eigen::Vector3d FlatSurface::allowed(const Freedom& freedom, VertexId v, const Eigen::Vector3d& step) const {
    switch (freedom.motion) {
        case VertexMotion::free: return step;
        case VertexMotion::plane: {
            const Patch& patch = patches_[static_cast<std::size_t>(freedom.carrier)];
            const Eigen::Vector3d n = patch.wall ? patch.wall->normal(mesh_->position(v)) : patch.normal;
            return step - n.dot(step) * n;
        }
        case VertexMotion::line: {
            const Eigen::Vector3d& d = lines_[static_cast<std::size_t>(freedom.carrier)].direction;
            return d.dot(step) * d;
        }
        case VertexMotion::fixed: break;
    }
    return Eigen::Vector3d::Zero();
}

Point3 FlatSurface::settled(VertexId v, const Point3& position) const {
    return settled({motion(v), freedom_[v].carrier}, position);
}

Point3 FlatSurface::settled(const Freedom& freedom, const Point3& position) const {
    if (freedom.motion == VertexMotion::plane) {
        const Patch& patch = patches_[static_cast<std::size_t>(freedom.carrier)];
        if (patch.wall) return patch.wall->nearest(position);
        return position - patch.normal.dot(position - patch.point) * patch.normal;
    }
    if (freedom.motion == VertexMotion::line) {
        const Line& line = lines_[static_cast<std::size_t>(freedom.carrier)];
        return line.point + line.direction.dot(position - line.point) * line.direction;
    }
    return position;
}

bool FlatSurface::has_room(VertexId v, const Point3& position) const {
    switch (motion(v)) {
        case VertexMotion::free: return true;
        case VertexMotion::plane: {
            const Patch& patch = patches_[static_cast<std::size_t>(freedom_[v].carrier)];
            if (patch.wall) return (patch.wall->nearest(position) - position).norm() <= half_tolerance_;
            return std::abs(patch.normal.dot(position - patch.point)) <= half_tolerance_;
        }
        case VertexMotion::line: {
            const Line& line = lines_[static_cast<std::size_t>(freedom_[v].carrier)];
            const Eigen::Vector3d from_start = position - line.point;
            return (from_start - line.direction.dot(from_start) * line.direction).norm() <= half_tolerance_;
        }
        case VertexMotion::fixed: break;
    }
    return false;
}

bool FlatSurface::allows_edge(std::int32_t patch, const Point3& p, const Point3& q) const {
    static const double least_cosine = std::cos(6 * std::numbers::pi / 180);
    const Wall* wall = patches_[static_cast<std::size_t>(patch)].wall;
    return !wall || wall->normal(p).dot(wall->normal(q)) >= least_cosine;
}

bool FlatSurface::is_ridge(const Complex& complex, EdgeId e, EdgeRing& ring) const {
    if (complex.surface_degree(e) != 2) return true;
    gather_ring(complex, e, ring);
    return flat_patch(complex, ring) == no_patch;
}

std::int32_t FlatSurface::flat_patch(const Complex& complex, const EdgeRing& ring) const {
    std::int32_t common = no_patch;
    for (std::size_t i = 0; i < ring.link.size(); ++i) {
        if (ring.is_closed && i + 1 == ring.link.size()) break;  // link[0] again
        // The face [a b link[i]] is opposite link[i + 1] in tetrahedron i, or opposite link[i - 1] in the one before.
        const bool is_last = i == ring.tets.size();
        const TetId t = ring.tets[is_last ? i - 1 : i];
        const VertexId opposite = is_last ? ring.link[i - 1] : ring.link[i + 1];
        const FaceId f = complex.faces(t)[static_cast<std::size_t>(complex.index_of(t, opposite))];
        if (!complex.is_surface(f)) continue;
        if (patch_[f] == no_patch || (common != no_patch && patch_[f] != common)) return no_patch;
        common = patch_[f];
    }
    return common;
}

}  // namespace dsc::dsc3d
