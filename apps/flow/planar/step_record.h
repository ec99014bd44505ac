// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a flow in the plane after a step, in figures, and what happened in it. Cost: linear in the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "apps/flow/component_tracker.h"
#include "core/fields.h"
#include "dsc2d/complex.h"
#include "dsc2d/components.h"
#include "dsc2d/label_statistics.h"
#include "motion/step_counts_fields.h"
#include "motion/step_report.h"

namespace dsc::flow::planar {

using dsc2d::Point2;

/// A vertex that did not reach its target.
struct Unfinished {
    Point2 place = Point2::Zero();
    Point2 remaining = Point2::Zero();
    bool is_in_contact = false;  ///< stopped by the topology policy
};

template <class Visitor, core::ConstOrNot<Unfinished> Value>
void fields(Visitor& visitor, Value& motion) {
    auto& [place, remaining, is_in_contact] = motion;
    visitor(place, remaining, is_in_contact);
}

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

template <class Visitor, core::ConstOrNot<StepRecord> Value>
void fields(Visitor& visitor, Value& record) {
    auto& [step, time, vertices, triangles, edges, unchanged, labels, min_angle, max_angle, inverted, is_complete,
           substeps, unfinished, counts, milliseconds] = record;
    visitor(step, time, vertices, triangles, edges, unchanged, labels, min_angle, max_angle, inverted, is_complete,
            substeps, unfinished, counts, milliseconds);
}

/// Knows the edges of the first interface by their vertices.
class UnchangedEdges {
public:
    using Key = std::array<std::uint32_t, 2>;
    /// With which it goes on for a complex with the same handles.
    struct State {
        std::vector<std::uint32_t> numbers;  ///< of the vertices
        std::vector<Key> first;
    };

    explicit UnchangedEdges(const dsc2d::Complex& complex);
    UnchangedEdges(const dsc2d::Complex& complex, const State& state);
    double share(const dsc2d::Complex& complex) const;
    State state() const;

private:
    std::vector<Key> numbered_edges(const dsc2d::Complex& complex) const;

    core::Attribute<core::VertexId, std::uint32_t> number_;  ///< from 1; 0: was not there
    std::vector<Key> first_;                                 ///< ascending
};

template <class Visitor, core::ConstOrNot<UnchangedEdges::State> Value>
void fields(Visitor& visitor, Value& state) {
    auto& [numbers, first] = state;
    visitor(numbers, first);
}

/// The cells of a planar complex, for its components.
struct Triangles {
    using Mesh = dsc2d::Complex;
    using Handle = core::FaceId;
    using Place = Point2;
    static auto attributes(const Mesh& mesh) { return mesh.face_attributes(); }
    static std::uint32_t capacity(const Mesh& mesh) { return mesh.face_capacity(); }
    static bool is_deleted(const Mesh& mesh, Handle f) { return mesh.is_deleted(f); }
    static int label(const Mesh& mesh, Handle f) { return mesh.label(f); }
    static Point2 centroid(const Mesh& mesh, Handle f) {
        const auto [a, b, c] = mesh.corners(f);
        return (a + b + c) / 3;
    }
    static core::DisjointSets components(const Mesh& mesh) { return dsc2d::components(mesh); }
};
using ComponentTracker = flow::ComponentTracker<Triangles>;

/// The figures of the mesh; those of the step stay at their defaults.
StepRecord step_record(const dsc2d::Complex& complex, int step, double time, const UnchangedEdges& unchanged);

/// The figures of a step from its report.
void add_step(StepRecord& record, const dsc2d::Complex& complex, const motion::StepReport<2>& report);

}  // namespace dsc::flow::planar
