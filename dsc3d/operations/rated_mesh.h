// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh whose tetrahedra are rated by a quality measure and whose surface may change where it is flat: what operations
// that improve quality judge and change. A change is proposed first (which tetrahedra go, which come, the worst quality
// before and after), then applied as one replace.
//
// Guarantee: apply() and move() keep every tetrahedron positive by exact predicate, or change nothing and say so.
// Every change stamps its vertices, so that a schedule visits only what has changed since it looked last.
// Cost: linear in the cavity; 16 bytes per tetrahedron beside the mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/attribute.h"
#include "dsc3d/complex/traversal.h"
#include "dsc3d/mesh.h"
#include "dsc3d/operations/flat_surface.h"
#include "dsc3d/operations/transaction.h"
#include "geometry/tetrahedron_quality.h"

namespace dsc::dsc3d {

/// The same tetrahedron rated from another vertex differs by rounding: smaller gains than this are none.
inline constexpr double least_quality_gain = 1e-9;

/// Vertices of a flat surface lie in their plane up to rounding only: of tetrahedra flatter than this, exact positivity
/// does not say whether surface faces overlap, so that no operation makes them there.
inline constexpr double least_surface_quality = 1e-9;

/// A change of the connectivity. `quality_before` and `quality_after` are the worst of what goes and what comes.
struct Proposal {
    std::vector<TetId> removed;
    std::vector<NewTet> added;
    /// Patches of the surface faces that come, with their vertices in any order.
    std::vector<SurfaceFace> surface;
    VertexId gone;   ///< the vertex that no tetrahedron has afterwards, if there is one
    VertexId moved;  ///< the vertex that has another place afterwards, if there is one; all its tetrahedra go
    Point3 place = Point3::Zero();  ///< of `moved`
    double quality_before = 0;
    double quality_after = 0;

    void clear() {
        removed.clear();
        added.clear();
        surface.clear();
        gone = moved = VertexId();
    }
    bool is_improvement() const { return quality_after > quality_before + least_quality_gain; }
};

class RatedMesh {
public:
    RatedMesh(Mesh& mesh, geometry::QualityMeasure measure, const FlatSurfaceParameters& parameters);
    /// `surface` has to be one of this mesh.
    RatedMesh(Mesh& mesh, geometry::QualityMeasure measure, FlatSurface surface);
    RatedMesh(const RatedMesh&) = delete;
    RatedMesh& operator=(const RatedMesh&) = delete;

    Mesh& mesh() { return *mesh_; }
    const Mesh& mesh() const { return *mesh_; }
    const Complex& complex() const { return mesh_->complex(); }
    FlatSurface& surface() { return surface_; }
    const FlatSurface& surface() const { return surface_; }
    geometry::QualityMeasure measure() const { return measure_; }
    double bias() const { return bias_; }
    /// Rates all tetrahedra anew by another measure; `bias` is that of the minimum biased sine.
    void set_measure(geometry::QualityMeasure measure, double bias = geometry::obtuse_bias);

    const Point3& position(VertexId v) const { return mesh_->position(v); }
    double quality(TetId t) const { return quality_[t]; }
    double worst_quality(std::span<const TetId> tets) const;
    double rate(VertexId a, VertexId b, VertexId c, VertexId d) const {
        return geometry::quality(measure_, position(a), position(b), position(c), position(d), bias_);
    }
    double rate(const TetVertices& v) const { return rate(v[0], v[1], v[2], v[3]); }

    /// From now on a collapse makes no edge longer than `growth` times the present mean length of the edges at its
    /// ends.
    void limit_edges(double growth);
    /// ... or than this.
    void set_longest_edge(VertexId v, double length) { longest_edge_[v] = length; }
    bool allows_edge(VertexId a, VertexId b) const {
        const double longest = std::max(longest_edge_[a], longest_edge_[b]);
        return (position(a) - position(b)).squaredNorm() <= longest * longest;
    }

    /// False, and nothing is changed, when a new tetrahedron is not positive by exact predicate.
    bool apply(const Proposal& proposal);
    /// The same with v, whose whole star is replaced, moved to `place`; false also when a new tetrahedron would be
    /// worse than `least`. Precondition: no transaction is open.
    bool apply_with(const Proposal& proposal, VertexId v, const Point3& place, double least);
    /// Moves a vertex; false, and nothing is changed, when a tetrahedron of `star` (all that have v) would not stay
    /// positive by exact predicate, or would be worse than `least`.
    bool move(VertexId v, const Point3& position, std::span<const TetId> star,
              double least = -std::numeric_limits<double>::infinity());
    /// Moves many vertices in one step. Preconditions: no transaction is open; `star` has, once each, all tetrahedra at
    /// the vertices; they are positive by exact predicate afterwards, and `qualities` are theirs then.
    void move_together(std::span<const VertexId> vertices, std::span<const Point3> positions,
                       std::span<const TetId> star, std::span<const double> qualities);
    /// The new vertex on e; invalid, and nothing is changed, when a part would not be positive by exact predicate.
    /// Precondition: e is not on an interface that has patches.
    VertexId split(EdgeId e, const Point3& position);
    void set_label(TetId t, int label);

    /// `p`, put on the plane, wall or line on which v may move along the boundary; as it is, when v lies inside.
    Point3 on_boundary(VertexId v, const Point3& p) const {
        return complex().is_boundary(v) ? surface_.along_boundary(v, position(v), p) : p;
    }
    /// Half-way between the ends of e; on the wall, when e is an edge of a curved one.
    Point3 middle(EdgeId e) const;

    /// From here on changes can be taken back, all at once. Precondition: no transaction is open.
    void begin() { transaction_.open(); }
    /// Keeps what has changed since begin().
    void commit() { transaction_.close(); }
    /// Takes back what has changed since begin().
    void roll_back();
    Transaction& transaction() { return transaction_; }

    /// The number of changes so far, and at the last change of the star of v.
    std::uint32_t time() const { return time_; }
    std::uint32_t changed(VertexId v) const { return changed_[v]; }

    StarWalker& walker() { return walker_; }

private:
    void exchange(std::span<const TetId> removed, std::span<const NewTet> added, std::span<const SurfaceFace> surface);
    std::array<std::int32_t, 2> boundary_patches(const EdgeRing& ring) const;
    void add_boundary_parts(const EdgeRing& ring, VertexId m, Proposal& parts);
    void rate_again(TetId t);

    Mesh* mesh_;
    geometry::QualityMeasure measure_;
    double bias_ = geometry::obtuse_bias;
    FlatSurface surface_;
    core::Attribute<TetId, double> quality_;
    core::Attribute<VertexId, std::uint32_t> changed_;
    core::Attribute<VertexId, double> longest_edge_;
    std::uint32_t time_ = 1;
    StarWalker walker_;
    Transaction transaction_;
};

}  // namespace dsc::dsc3d
