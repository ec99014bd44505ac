// SPDX-License-Identifier: GPL-3.0-or-later
// Escapes from the local maxima where hill climbing stops: one change for the worse near a poor tetrahedron, hill
// climbing around it, and the whole is kept if it lowers an energy that poor tetrahedra dominate; otherwise it is taken
// back. Where all vertices near by are fixed, a vertex from elsewhere is the only way out (relocation.h). Source:
// thesis 3.6, which names the problem and randomization as the way out. Guarantee: the worst quality of the mesh never
// decreases, and the number of vertices never increases. Cost: about a millisecond per attempt.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "dsc3d/improve/passes.h"
#include "dsc3d/operations/relocation.h"

namespace dsc::dsc3d {

struct EscapeParameters {
    /// Of the energy sum (worst quality / quality)^power, which weighs one tetrahedron that is 10 % better than the
    /// worst one as much as power = 12 says: a third.
    double power = 12;
    double least_gain = 1e-3;  ///< of the energy, in units of one worst tetrahedron
    int longest_kick = 3;      ///< changes, some of them for the worse, before hill climbing
    int settling_rounds = 3;   ///< of hill climbing around the change
    bool removes_vertices = true;
    bool relocates_vertices = true;  ///< takes vertices inside regions to where they help
    double longest_push = 0.4;       ///< of a vertex, in mean edge lengths at it
    int longest_walk = 12;           ///< from a poor tetrahedron to one with a vertex that can come to it
};

class Escapes {
public:
    Escapes(RatedMesh& mesh, Passes& passes, const EscapeParameters& parameters, std::uint64_t seed);

    struct Attempt {
        bool is_kept = false;
        std::size_t cost = 0;  ///< in tetrahedra changed, and some for the search itself
    };
    /// One attempt at t, in a mesh whose worst quality is `worst`.
    Attempt attempt(TetId t, double worst);
    /// The tetrahedra that the last attempt that was kept has made or changed.
    std::span<const TetId> changed() const { return changed_; }

private:
    bool kick(TetId t);
    bool kick_edge(EdgeId e);
    bool kick_face(FaceId f);
    bool kick_collapse(EdgeId e, VertexId kept);
    bool kick_vertex(VertexId v);
    bool kick_relocation(TetId t);
    void settle();
    bool is_better(double worst);
    TetId random_neighbour(TetId t);

    RatedMesh& mesh_;
    Passes& passes_;
    EscapeParameters parameters_;
    core::Random random_;
    EdgeRemoval edge_removal_;
    MultiFace multi_face_;
    EdgeCollapse collapse_;
    Relocation relocation_;
    Proposal proposal_;
    std::vector<VertexId> region_;
    std::vector<TetId> tets_;
    std::vector<TetId> changed_;
};

}  // namespace dsc::dsc3d
