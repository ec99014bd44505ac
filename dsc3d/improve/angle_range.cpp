// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/angle_range.h"

#include <algorithm>
#include <numbers>

#include "geometry/tetrahedron_quality.h"

namespace dsc::dsc3d {

AngleRange::AngleRange(const Mesh& mesh) : min(std::numbers::pi), max(0) {
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity(); ++i) {
        if (mesh.complex().is_deleted(TetId(i))) continue;
        const TetVertices& v = mesh.complex().vertices(TetId(i));
        for (const double angle : geometry::dihedral_angles(mesh.position(v[0]), mesh.position(v[1]),
                                                            mesh.position(v[2]), mesh.position(v[3]))) {
            min = std::min(min, angle);
            max = std::max(max, angle);
        }
    }
}

}  // namespace dsc::dsc3d
