// SPDX-License-Identifier: GPL-3.0-or-later
// The interface around a vertex of a tetrahedral mesh, as the algorithms of surface/ want to see it.
// Source: thesis 4.3.2.2. Guarantee: normals point to the side of the lower label; at seams all sheets are there.
// Cost: linear in the star; buffers are reused.
#pragma once

#include <vector>

#include "dsc3d/operations/rated_mesh.h"
#include "surface/one_ring.h"

namespace dsc::dsc3d {

class InterfaceRing {
public:
    /// The ring is valid until the next call or change of the mesh.
    surface::OneRing gather(RatedMesh& mesh, VertexId v);

private:
    std::vector<surface::RingTriangle> triangles_;
};

}  // namespace dsc::dsc3d
