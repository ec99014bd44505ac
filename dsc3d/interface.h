// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a mesh as a surface with the labels on either side. Source: thesis 4.3 (the interface is made of the
// faces between different labels). Guarantee: normals point to the side of the lower label; vertices and triangles in
// the order of their handles; the coordinates of the mesh. Cost: linear in the mesh.
//
//     const dsc3d::Interface interface(mesh);
//     io::write_surface_mesh("final.obj", interface.data.surface);
#pragma once

#include <vector>

#include "dsc3d/mesh.h"
#include "geometry/interface_data.h"

namespace dsc::dsc3d {

struct Interface {
    geometry::InterfaceData data;
    std::vector<VertexId> vertices;  ///< of the mesh, one for each of the surface
    std::vector<FaceId> faces;       ///< of the mesh, one for each triangle

    explicit Interface(const Mesh& mesh);
};

}  // namespace dsc::dsc3d
