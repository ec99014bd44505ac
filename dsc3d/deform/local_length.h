// SPDX-License-Identifier: GPL-3.0-or-later
// The wanted edge length at every vertex: on the interface what the caller asks for, off it growing with the distance
// along the edges. Source: thesis 4.3.2.1 (detail control); gradation: Borouchaki, Hecht, Frey, "Mesh gradation
// control" (1998). Guarantee: off the interface it is at most that of a neighbour and growth times the
// distance, after what has moved was updated. Cost: construction linear in the edges, times the rings between interface
// and boundary; an update linear in the stars of the vertices.
#pragma once

#include <span>
#include <vector>

#include "core/attribute.h"
#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

class LocalLength {
public:
    /// `growth` per distance. In a mesh without interface the length is the same everywhere.
    LocalLength(const Mesh& mesh, double on_interface, double growth);

    double at(VertexId v) const { return length_[v]; }
    void set(VertexId v, double length) { length_[v] = length; }
    /// Vertices off the interface follow their neighbours.
    void update(RatedMesh& mesh, std::span<const VertexId> vertices);

private:
    /// A vertex off the interface with its neighbours, and what it may be longer than each of them.
    struct Follower {
        VertexId vertex;
        std::size_t begin, end;
    };
    struct Neighbour {
        VertexId vertex;
        double rise;
    };

    void gather_followers(RatedMesh& mesh, std::span<const VertexId> vertices);
    double allowed(const Follower& follower) const;

    double growth_;
    core::Attribute<VertexId, double> length_;
    std::vector<Follower> followers_;
    std::vector<Neighbour> neighbours_;
    std::vector<VertexId> around_;
};

}  // namespace dsc::dsc3d
