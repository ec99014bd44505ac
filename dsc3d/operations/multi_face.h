// SPDX-License-Identifier: GPL-3.0-or-later
// The faces sandwiched between two vertices a (above) and b (below), and the two operations on them:
//
// multi-face removal: a connected part of them goes, the edge ab comes; the inverse of edge removal. The best part is
// found by dynamic programming over the tree of faces (Shewchuk).
// multi-face retriangulation: all of them that are connected give way to the best triangulation of their polygon, with
// a and b as before; the number of tetrahedra stays. It also works on the surface: below is then nothing, or another
// region, and the faces belong to one flat patch.
//
// Source: thesis 3.2.2, 3.3.1; de Cougny and Shephard; Shewchuk, "Two discrete optimization algorithms for the
// topological improvement of tetrahedral meshes". Cost: linear in the faces; n^3 / 3 ratings to retriangulate.
#pragma once

#include <array>
#include <optional>

#include "dsc3d/operations/rated_mesh.h"

namespace dsc::dsc3d {

class MultiFace {
public:
    /// Larger ones are cut off (removal) or left alone (retriangulation).
    static constexpr int max_faces = 24;

    /// Finds the multi-face of f, for the two operations, which are valid until the mesh changes.
    void gather(const RatedMesh& mesh, FaceId f);

    /// The connected set of faces with f whose removal leaves the best worst tetrahedron, if that is better than
    /// `wanted`; by default better than before. Where the faces go once around a vertex, sets that are connected only
    /// across the last edge of the round are not considered.
    bool propose_removal(const RatedMesh& mesh, Proposal& proposal, std::optional<double> wanted = {});

    /// The best triangulation of the multi-face, if its worst tetrahedron is better than `wanted`; by default better
    /// than before.
    bool propose_retriangulation(RatedMesh& mesh, Proposal& proposal, std::optional<double> wanted = {});

private:
    /// A face [v0 v1 v2], counterclockwise seen from a. All faces but the first, which f is, were entered across their
    /// edge 2, the one opposite v2. `next[i]` is the face that was entered across edge i of this one, or -1.
    struct Face {
        FaceVertices vertices;
        TetId above, below;
        std::array<int, 3> next = {-1, -1, -1};
        std::array<double, 3> best = {};   ///< worst of what comes beyond edge i, when that is chosen best
        std::array<bool, 3> goes_on = {};  ///< whether then the face across edge i goes too
    };

    void add_neighbours(const RatedMesh& mesh, std::size_t i);
    void choose_beyond(const RatedMesh& mesh, Face& face, std::size_t edge);
    void collect(const Face& face, std::size_t edges, Proposal& proposal) const;
    bool find_polygon();
    bool joins_again(RatedMesh& mesh, VertexId x, VertexId y) const;

    VertexId a_, b_;  ///< b is invalid on the boundary
    bool is_surface_ = false;
    std::int32_t patch_ = FlatSurface::no_patch;  ///< of the faces, when they are on the surface
    int label_above_ = 0;
    int label_below_ = 0;
    std::vector<Face> faces_;
    std::vector<VertexId> polygon_;
};

}  // namespace dsc::dsc3d
