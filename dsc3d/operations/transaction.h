// SPDX-License-Identifier: GPL-3.0-or-later
// The record of a compound change that can be taken back: what the operations since its beginning have replaced, moved
// and removed. A schedule tries several operations one after the other, some of them for the worse, looks at the whole,
// and keeps it or puts the copy of the cavity back in one replace (RatedMesh::roll_back).
// Guarantee: taking back restores tetrahedra, labels, positions, patches, freedom and handles of vertices; handles of
// the other simplices are new. Cost: constant per simplex touched; nothing is allocated in the long run.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/attribute.h"
#include "dsc3d/mesh.h"
#include "dsc3d/operations/flat_surface.h"

namespace dsc::dsc3d {

/// A surface face by its vertices, in any order, and its patch.
struct SurfaceFace {
    FaceVertices vertices;
    std::int32_t patch;
};

class Transaction {
public:
    explicit Transaction(const Complex& complex);

    bool is_open() const { return is_open_; }
    /// Qualities, at the beginning, of the tetrahedra that are gone or have changed their shape.
    std::span<const double> qualities_before() const { return qualities_before_; }
    /// The tetrahedra that have come or have changed their shape.
    std::span<const TetId> touched();

private:
    friend class RatedMesh;

    enum class State : std::uint8_t { untouched, changed, added };
    struct RemovedVertex {
        VertexId vertex;
        Point3 position;
        FlatSurface::Freedom freedom;
        double longest_edge;
    };

    void open();
    void close();
    void note_removal(const Mesh& mesh, const FlatSurface& surface, TetId t, double quality);
    void note_vertex_removal(const Mesh& mesh, const FlatSurface& surface, VertexId v, double longest_edge);
    void note_new(TetId t);
    void note_change(TetId t, double quality);
    void note_move(VertexId v, const Point3& before);
    bool is_added(TetId t) const { return state_[t] == State::added; }

    const Complex* complex_;
    bool is_open_ = false;
    core::Attribute<TetId, State> state_;
    core::Attribute<VertexId, std::uint8_t> is_moved_;
    std::vector<double> qualities_before_;
    std::vector<TetId> touched_;  ///< may be gone again, or occur twice
    std::vector<NewTet> originals_;
    std::vector<SurfaceFace> original_surface_;
    std::vector<std::pair<VertexId, Point3>> moves_;
    std::vector<RemovedVertex> removed_vertices_;
};

}  // namespace dsc::dsc3d
