// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh improvement where it is needed: the poor tetrahedra of the region are smoothed, retriangulated or thinned until
// none is left or nothing helps; those that hill climbing leaves bad are escaped from, or get a vertex of their own.
// Source: thesis 4.3.2.1 ("mesh quality improvement" of the active set) with the operations of chapter 3; 3.6 for
// escapes. Guarantee: no operation makes the worst tetrahedron it touches worse; no vertex of an interface moves or
// goes, and those of the boundary only within its planes and along its straight ridges. Cost: linear in the number of
// poor tetrahedra.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dsc3d/deform/pass_context.h"
#include "dsc3d/improve/escapes.h"
#include "dsc3d/improve/passes.h"

namespace dsc::dsc3d {

class Upkeep {
public:
    Upkeep(RatedMesh& mesh, std::uint64_t seed);

    /// Hill climbing in the region.
    void run(PassContext& context);
    /// Moves every vertex of the region that may move to where its tetrahedra are best.
    void smooth(PassContext& context);
    /// Escapes and new vertices for what is still bad in the region: dear.
    void rescue(PassContext& context);

private:
    void climb(PassContext& context);
    bool mend(const PassContext& context, TetId t);
    void escape(PassContext& context);
    void insert_vertices(PassContext& context);
    bool insert_vertex(PassContext& context, TetId t);
    void gather(const RatedMesh& mesh, std::span<const TetId> tets, double below);

    Passes passes_;
    Escapes escapes_;
    std::vector<TetId> poor_;
    Region around_;
    core::Attribute<TetId, std::uint8_t> failures_;  ///< of escapes
};

}  // namespace dsc::dsc3d
