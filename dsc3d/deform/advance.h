// SPDX-License-Identifier: GPL-3.0-or-later
// Motion of many vertices at once, as far as that inverts or spoils nothing. Neighbours on an interface keep each other
// from moving when they go one after another, because the tetrahedra between them turn over on the way; together they
// don't. Vertices off the interface are carried along by the mean motion of their neighbours, fading with the distance
// from it, so that what moves rigidly drags its surroundings with it.
// Source: not in the thesis; what it leaves goes through algorithm 5. Guarantee: one operation: the final tetrahedra
// are all judged exactly before anything moves. As incidence stays and all tetrahedra stay positive, the complex
// remains an embedding: no part of the interface can pass another, however far it moves. Cost: linear in the stars of
// the vertices that move.
#pragma once

#include <span>
#include <vector>

#include "core/attribute.h"
#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

struct AdvanceParameters {
    double least_quality;  ///< tetrahedra don't become worse than this, or than they are
    int carried_rings;
    int sweeps = 6;    ///< of averaging
    int halvings = 3;  ///< of the way of vertices that are in each other's way, before they stay
};

class Advance {
public:
    explicit Advance(const Mesh& mesh);

    /// Moves `vertices`, each once in the list, towards their targets, and those around them that are not fixed to a
    /// surface.
    /// Afterwards region() lists the tetrahedra that have changed.
    void run(RatedMesh& mesh, std::span<const VertexId> vertices, const core::Attribute<VertexId, Point3>& target,
             const AdvanceParameters& parameters);

    std::span<const TetId> region() const { return tets_; }
    /// Vertices off the surface that were carried.
    std::span<const VertexId> carried() const { return {movers_.data() + targeted_, movers_.size() - targeted_}; }

private:
    void gather(RatedMesh& mesh, std::span<const VertexId> vertices, const AdvanceParameters& parameters);
    void spread(const RatedMesh& mesh, int sweeps);
    void hold_back(RatedMesh& mesh, const AdvanceParameters& parameters);
    void apply(RatedMesh& mesh);

    bool is_mover(VertexId v) const { return place_[v] != 0; }
    bool is_targeted(VertexId v) const { return is_mover(v) && place_[v] <= targeted_; }
    Point3 there(const RatedMesh& mesh, VertexId v) const {
        if (!is_mover(v)) return mesh.position(v);
        const std::size_t i = place_[v] - 1;
        if (share_[i] == 1) return goal_[i];
        return mesh.on_boundary(v, mesh.position(v) + share_[i] * (goal_[i] - mesh.position(v)));
    }
    double rate(const RatedMesh& mesh, TetId t, bool& is_positive) const;

    core::Attribute<VertexId, std::uint32_t> place_;   ///< in movers_, from 1; 0: stays
    core::Attribute<TetId, std::uint32_t> tet_place_;  ///< in tets_, from 1
    std::vector<VertexId> movers_;                     ///< the targeted ones first
    std::size_t targeted_ = 0;
    std::vector<Point3> goal_;
    std::vector<Point3> step_;
    std::vector<double> share_;
    std::vector<TetId> tets_;
    std::vector<double> quality_;
    std::vector<Point3> sum_;
    std::vector<double> count_;
};

}  // namespace dsc::dsc3d
