// SPDX-License-Identifier: GPL-3.0-or-later
// A numbering in which what is near in space is near in memory, for the duration of a run: passes over a large mesh
// whose numbering is random wait for memory most of their time. Vertices are numbered along a Morton curve, the rest by
// its least vertex. Guarantee: restore() brings back the order of the vertices and tetrahedra that are still there;
// tetrahedra that have come follow them. Cost: n log n, some 0.5 us per tetrahedron; 4 bytes per tetrahedron meanwhile.
#pragma once

#include <cstdint>

#include "core/attribute.h"
#include "dsc3d/mesh.h"

namespace dsc::dsc3d {

class SpatialOrder {
public:
    /// All handles of the mesh change, attributes follow. The mesh has to stay at its address.
    explicit SpatialOrder(Mesh& mesh);
    /// Once more. Precondition: no vertex was added meanwhile. Where it is not called, as when an exception ends the run,
    /// the mesh is as valid as before, in the new numbering.
    void restore();

private:
    Mesh& mesh_;
    core::Attribute<VertexId, std::uint32_t> vertex_place_;
    core::Attribute<TetId, std::uint32_t> tet_place_;
};

}  // namespace dsc::dsc3d
