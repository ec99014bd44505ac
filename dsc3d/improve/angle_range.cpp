// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/angle_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/tetrahedron_quality.h"

namespace dsc::dsc3d {

AngleRange::AngleRange(const Mesh& mesh) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity(); ++i) {
        if (mesh.complex().is_deleted(TetId(i))) continue;
        const TetVertices& v = mesh.complex().vertices(TetId(i));
        for (const double cotangent : geometry::dihedral_cotangents(mesh.position(v[0]), mesh.position(v[1]),
                                                                    mesh.position(v[2]), mesh.position(v[3]))) {
            least = std::min(least, cotangent);
            greatest = std::max(greatest, cotangent);
        }
    }
    min = std::atan2(1.0, greatest);
    max = std::atan2(1.0, least);
}

}  // namespace dsc::dsc3d
