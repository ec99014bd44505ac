// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a flow after a step, in figures, and what happened in it. Cost: linear in the mesh.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "apps/flow/component_tracker.h"
#include "core/fields.h"
#include "dsc3d/components.h"
#include "dsc3d/label_statistics.h"
#include "dsc3d/mesh.h"
#include "motion/step_counts_fields.h"
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
    bool is_complete = true;   ///< all motion was made, but for vertices in contact
    int substeps = 0;
    std::size_t unfinished = 0;    ///< vertices that did not reach their targets
    std::size_t in_contact = 0;    ///< ... because of a contact
    double largest_remainder = 0;  ///< of their motion
    motion::StepCounts counts;
    std::vector<std::pair<std::string, double>> milliseconds;  ///< by phase
};

template <class Visitor, core::ConstOrNot<StepRecord> Value>
void fields(Visitor& visitor, Value& record) {
    auto& [step, time, vertices, tets, faces, unchanged, labels, min_dihedral, max_dihedral, min_quality, inverted,
           is_complete, substeps, unfinished, in_contact, remainder, counts, milliseconds] = record;
    visitor(step, time, vertices, tets, faces, unchanged, labels, min_dihedral, max_dihedral, min_quality, inverted,
            is_complete, substeps, unfinished, in_contact, remainder, counts, milliseconds);
}

/// Knows the triangles of the first interface by their vertices.
class UnchangedTriangles {
public:
    using Key = std::array<std::uint32_t, 3>;
    /// With which it goes on for a mesh made again from its data.
    struct State {
        std::vector<std::uint32_t> numbers;  ///< of the vertices
        std::vector<Key> first;
    };

    explicit UnchangedTriangles(const dsc3d::Mesh& mesh);
    UnchangedTriangles(const dsc3d::Mesh& mesh, const State& state);
    double share(const dsc3d::Mesh& mesh) const;
    State state(const dsc3d::Mesh& mesh) const;

private:
    std::vector<Key> numbered_triangles(const dsc3d::Mesh& mesh) const;

    core::Attribute<dsc3d::VertexId, std::uint32_t> number_;  ///< from 1; 0: was not there
    std::vector<Key> first_;                                  ///< ascending
};

template <class Visitor, core::ConstOrNot<UnchangedTriangles::State> Value>
void fields(Visitor& visitor, Value& state) {
    auto& [numbers, first] = state;
    visitor(numbers, first);
}

/// The cells of a tetrahedral mesh, for its components.
struct Tets {
    using Mesh = dsc3d::Mesh;
    using Handle = dsc3d::TetId;
    using Place = Point3;
    static auto attributes(const Mesh& mesh) { return mesh.complex().tet_attributes(); }
    static std::uint32_t capacity(const Mesh& mesh) { return mesh.complex().tet_capacity(); }
    static bool is_deleted(const Mesh& mesh, Handle t) { return mesh.complex().is_deleted(t); }
    static int label(const Mesh& mesh, Handle t) { return mesh.complex().label(t); }
    static Point3 centroid(const Mesh& mesh, Handle t) {
        const auto& [a, b, c, d] = mesh.complex().vertices(t);
        return 0.25 * (mesh.position(a) + mesh.position(b) + mesh.position(c) + mesh.position(d));
    }
    static core::DisjointSets components(const Mesh& mesh) { return dsc3d::components(mesh.complex()); }
};

/// The figures of the mesh; those of the step stay at their defaults.
StepRecord step_record(const dsc3d::Mesh& mesh, int step, double time, const UnchangedTriangles& unchanged);

/// The figures of a step from its report.
void add_step(StepRecord& record, const motion::StepReport<3>& report);

}  // namespace dsc::flow
