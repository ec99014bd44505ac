// SPDX-License-Identifier: GPL-3.0-or-later
// Where the surface (boundary and interfaces) may be changed without moving it. Its faces are gathered in flat patches;
// a vertex is free inside a region, slides in the plane of its patch, slides on a straight ridge, or is fixed. A curved
// wall of the domain is a patch too, on which vertices slide by projection.
//
// Source: thesis 3.3 ("sufficiently flat", "straight ridges"). Guarantee: all vertices of a patch lie within half the
// tolerance of one plane, all vertices of a ridge within half of it of one segment, and planes and segments are those
// of the input however often vertices move: the surface stays within the tolerance of the input surface. Vertices of a
// curved wall lie on it within rounding; its triangles are chords, so that what is changed there changes the volume of
// the domain, but makes no edge over which the wall turns by more than 6 degrees. Cost: linear in the surface to make;
// queries are array reads.
#pragma once

#include <cstdint>
#include <vector>

#include "core/attribute.h"
#include "dsc3d/complex/traversal.h"
#include "dsc3d/mesh.h"
#include "dsc3d/operations/wall.h"

namespace dsc::dsc3d {

struct FlatSurfaceParameters {
    bool may_change = true;     ///< false: every vertex of the surface is fixed, every face a patch of its own
    double tolerance = 1e-9;    ///< largest move of the surface [diagonals of the bounding box]
    double feature_angle = 30;  ///< edges bent by more are ridges [degree]
};

enum class VertexMotion : std::uint8_t { free, plane, line, fixed };

class FlatSurface {
public:
    static constexpr std::int32_t no_patch = -1;

    /// How a vertex may move, and on which plane or line.
    struct Freedom {
        VertexMotion motion = VertexMotion::free;
        std::int32_t carrier = -1;
    };

    FlatSurface(const Mesh& mesh, const FlatSurfaceParameters& parameters);
    /// A surface that stays as it is, also while labels change: what is on the surface is fixed, what is off it is
    /// free. The mesh must stay at its address.
    static FlatSurface rigid(const Mesh& mesh);
    /// A surface whose interfaces stay as they are, also while labels change, and whose boundary may change where it is
    /// flat, by no more than rounding, or within one of the walls, on which its vertices stay. The faces of a wall are
    /// those whose corners lie on it, within half the tolerance. The mesh must stay at its address.
    static FlatSurface flat_boundary(const Mesh& mesh, Walls walls = {});

    /// Whether the face has a patch: only those faces may give way to others.
    bool has_patch(const Complex& complex, FaceId f) const {
        switch (kind_) {
            case Kind::flat: return complex.is_surface(f);
            case Kind::flat_boundary: return complex.is_boundary(f);
            case Kind::rigid: break;
        }
        return false;
    }

    /// The patch of a surface face; faces of two patches are never exchanged.
    std::int32_t patch(FaceId f) const { return patch_[f]; }
    void set_patch(FaceId f, std::int32_t patch) { patch_[f] = patch; }

    VertexMotion motion(VertexId v) const {
        if (kind_ == Kind::flat) return freedom_[v].motion;
        if (!mesh_->complex().is_surface(v)) return VertexMotion::free;
        return kind_ == Kind::rigid || mesh_->complex().is_interface(v) ? VertexMotion::fixed : freedom_[v].motion;
    }
    const Freedom& freedom(VertexId v) const { return freedom_[v]; }
    void set_freedom(VertexId v, const Freedom& freedom) { freedom_[v] = freedom; }
    /// The freedom of a new vertex on the boundary edge of these places and freedoms, between faces of these patches.
    Freedom freedom_between(const std::array<Point3, 2>& places, const std::array<Freedom, 2>& freedoms,
                            const std::array<std::int32_t, 2>& patches);
    /// `step` reduced to a direction in which v may move.
    Eigen::Vector3d allowed(VertexId v, const Eigen::Vector3d& step) const;
    /// `position` put back on the plane or segment of v, whose rounding errors would add up otherwise.
    Point3 settled(VertexId v, const Point3& position) const;
    /// The same for a vertex of the boundary that an interface takes along it.
    Eigen::Vector3d allowed_on_boundary(VertexId v, const Eigen::Vector3d& step) const {
        return allowed(freedom_[v], v, step);
    }
    /// The place on the patch for a new vertex that is to come to `position`, between its vertices.
    Point3 on_patch(std::int32_t patch, const Point3& position) const {
        const Wall* wall = patches_[static_cast<std::size_t>(patch)].wall;
        return wall ? wall->nearest(position) : position;
    }
    /// Whether an edge of the patch may come between these places: where it would cut off too much of a curved wall,
    /// not.
    bool allows_edge(std::int32_t patch, const Point3& p, const Point3& q) const;
    /// Where a vertex of the boundary goes that is sent to `position` along it, as an interface that slides on a wall
    /// takes it: the nearest place in its plane, on its wall or on the line of its segment; its present place, when it
    /// is a corner.
    Point3 along_boundary(VertexId v, const Point3& present, const Point3& position) const {
        return freedom_[v].motion == VertexMotion::fixed ? present : settled(freedom_[v], position);
    }
    /// Whether `position` is within half the tolerance of the plane or line of v. A settled one need not be: far from
    /// the origin, or with a tolerance of 0, rounding alone is more.
    bool has_room(VertexId v, const Point3& position) const;

    /// An edge of the surface that has to stay: not between two faces of one patch.
    bool is_ridge(const Complex& complex, EdgeId e, EdgeRing& ring) const;
    /// The patch whose faces meet at the surface edge of `ring`, or no_patch at a ridge.
    std::int32_t flat_patch(const Complex& complex, const EdgeRing& ring) const;

private:
    Point3 settled(const Freedom& freedom, const Point3& position) const;
    Eigen::Vector3d allowed(const Freedom& freedom, VertexId v, const Eigen::Vector3d& step) const;

    enum class Kind : std::uint8_t { flat, flat_boundary, rigid };

    struct Patch {
        Point3 point;  ///< of its plane
        Eigen::Vector3d normal;
        const Wall* wall = nullptr;  ///< of walls_: then there is no plane
    };
    struct Line {
        Point3 point;
        Eigen::Vector3d direction;
    };

    class Builder;

    FlatSurface(const Mesh& mesh, Kind kind, Walls walls);

    core::Attribute<FaceId, std::int32_t> patch_;
    core::Attribute<VertexId, Freedom> freedom_;
    std::vector<Patch> patches_;
    std::vector<Line> lines_;
    Walls walls_;
    double half_tolerance_ = 0;  ///< a length
    Kind kind_ = Kind::flat;
    const Mesh* mesh_ = nullptr;  ///< where flags and places are asked for, because interfaces change
};

}  // namespace dsc::dsc3d
