// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a flow after a step, in figures, and what happened in it. Cost: linear in the mesh.
#pragma once

#include <array>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "dsc3d/label_statistics.h"
#include "dsc3d/mesh.h"
#include "motion/step_report.h"

namespace dsc::flow {

using geometry::Point3;

struct StepRecord {
    int step = 0;  ///< 0: before the first one
    double time = 0;
    std::size_t vertices = 0;
    std::size_t tets = 0;
    std::size_t interface_faces = 0;
    double unchanged_share = 1;  ///< of the first interface's triangles that are still there
    std::vector<dsc3d::LabelStatistics> labels;
    double min_dihedral = 0;   ///< [degree]
    double max_dihedral = 0;   ///< [degree]
    double min_quality = 0;    ///< volume-length ratio
    std::size_t inverted = 0;  ///< by exact predicate
    bool is_complete = true;   ///< all motion was made
    int substeps = 0;
    std::size_t unfinished = 0;    ///< vertices that did not reach their targets
    double largest_remainder = 0;  ///< of their motion
    motion::StepCounts counts;
    std::vector<std::pair<std::string, double>> milliseconds;  ///< by phase
};

/// Knows the triangles of the first interface by their vertices: a vertex that was removed counts as changed as long as
/// its number isn't used again.
class UnchangedTriangles {
public:
    explicit UnchangedTriangles(const dsc3d::Mesh& mesh);
    double share(const dsc3d::Mesh& mesh) const;

private:
    using Key = std::array<std::uint32_t, 3>;
    std::vector<Key> first_;  ///< ascending
};

/// The figures of the mesh; those of the step stay at their defaults.
StepRecord step_record(const dsc3d::Mesh& mesh, int step, double time, const UnchangedTriangles& unchanged);

/// The figures of a step from its report.
void add_step(StepRecord& record, const motion::StepReport<3>& report);

}  // namespace dsc::flow
