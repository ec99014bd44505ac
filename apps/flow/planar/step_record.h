// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a flow in the plane after a step, in figures, and what happened in it. Cost: linear in the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "dsc2d/complex.h"
#include "dsc2d/label_statistics.h"
#include "motion/step_report.h"

namespace dsc::flow::planar {

using dsc2d::Point2;

/// A vertex that did not reach its target.
struct Unfinished {
    Point2 place = Point2::Zero();
    Point2 remaining = Point2::Zero();
    bool is_in_contact = false;  ///< stopped by the topology policy
};

struct StepRecord {
    int step = 0;  ///< 0: before the first one
    double time = 0;
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t interface_edges = 0;
    double unchanged_share = 1;  ///< of the first interface's edges that are still there
    std::vector<dsc2d::LabelStatistics> labels;
    double min_angle = 0;      ///< [degree]
    double max_angle = 0;      ///< [degree]
    std::size_t inverted = 0;  ///< by exact predicate
    bool is_complete = true;   ///< all motion was made, but for vertices in contact
    int substeps = 0;
    std::vector<Unfinished> unfinished;
    motion::StepCounts counts;
    std::vector<std::pair<std::string, double>> milliseconds;  ///< by phase
};

/// Knows the edges of the first interface by their vertices.
class UnchangedEdges {
public:
    explicit UnchangedEdges(const dsc2d::Complex& complex);
    double share(const dsc2d::Complex& complex) const;

private:
    using Key = std::array<std::uint32_t, 2>;
    std::vector<Key> numbered_edges(const dsc2d::Complex& complex) const;

    core::Attribute<core::VertexId, std::uint32_t> number_;  ///< from 1; 0: was not there
    std::vector<Key> first_;                                 ///< ascending
};

/// Knows the components of all labels, and which of them are no longer there.
class ComponentTracker {
public:
    explicit ComponentTracker(const dsc2d::Complex& complex);

    struct Component {
        int label = 0;
        Point2 centroid = Point2::Zero();  ///< of one of its triangles, on a torus in whatever period
    };
    /// Those that have vanished since the last call.
    std::vector<Component> update(const dsc2d::Complex& complex);

private:
    void number_components(const dsc2d::Complex& complex);

    core::Attribute<core::FaceId, std::uint32_t> component_;  ///< from 1; 0: a new face
    std::vector<Component> components_;
};

/// The figures of the mesh; those of the step stay at their defaults.
StepRecord step_record(const dsc2d::Complex& complex, int step, double time, const UnchangedEdges& unchanged);

/// The figures of a step from its report.
void add_step(StepRecord& record, const dsc2d::Complex& complex, const motion::StepReport<2>& report);

}  // namespace dsc::flow::planar
