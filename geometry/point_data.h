// SPDX-License-Identifier: GPL-3.0-or-later
// A point cloud as plain arrays.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace dsc::geometry {

struct PointData {
    std::vector<Eigen::Vector3d> points;
    /// One for each point, of any length, or none at all.
    std::vector<Eigen::Vector3d> normals;
};

}  // namespace dsc::geometry
