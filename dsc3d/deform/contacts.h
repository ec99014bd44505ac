// SPDX-License-Identifier: GPL-3.0-or-later
// Where parts of the interface collide: the thin region between them, as far as it is thin, is given to the region that
// touches most of it, and so is what else is needed for both to be manifolds there. Objects merge when the background
// is squeezed away between them, and split when they are themselves. In the same way they come to a wall of the domain,
// when the background is squeezed away in front of it, and leave it, when the last of their contact is. Source:
// thesis 4.3.2.1 (relabelling), 5.2.1 (topology control). Guarantee: a change of labels leaves every tetrahedron as it
// is, so that nothing can become invalid; what a policy forbids is not made; labels change in one direction only: what
// has won a place is not squeezed away there in the same step. Cost: linear in the region and in what changes.
#pragma once

#include <span>
#include <vector>

#include "dsc3d/deform/facing.h"
#include "dsc3d/deform/foot.h"
#include "dsc3d/deform/pinches.h"

namespace dsc::dsc3d {

class Contacts {
public:
    explicit Contacts(const Mesh& mesh);

    /// From here on labels may change in any direction again.
    void begin_step() {
        ++step_;
        touched_in_step_.clear();
    }
    /// Treats the contacts in the region, where sheets come closer than the distance. True when a label was changed.
    bool run(PassContext& context, int substep, double distance);
    /// Opens what pinches are left at the vertices of everything that has changed its label in this step: those that a
    /// label could not open since it had lost there what another one had won. Afterwards touched() are the vertices of
    /// what has changed. True when a label was changed.
    bool open_leftovers(PassContext& context);
    /// The vertices of what has changed its label in the last run, ascending.
    std::span<const VertexId> touched() const { return touched_; }

    /// Adds the contacts in the region that the policy forbids to the report.
    static void report_held(PassContext& context);

private:
    /// What a label has won: all tetrahedra at a vertex.
    struct Claim {
        std::uint32_t step = 0;
        int winner = 0;
    };

    bool may_give_way(const PassContext& context, TetId t) const;
    void close_gap(PassContext& context, TetId seed, int substep);
    void lift_foot(PassContext& context, TetId seed, int substep);
    void give_way(PassContext& context, TetId seed, int substep);
    void gather_gap(PassContext& context, TetId seed);
    std::optional<int> winner(const PassContext& context) const;
    void open_pinches(PassContext& context, std::size_t first_touched, int winner, int loser);
    void open_pinches_at(PassContext& context, VertexId v, int winner, int loser);
    void fill_notches(PassContext& context, std::size_t first_touched, int winner, int loser);
    void absorb_crumbs(PassContext& context, int loser);
    void give(PassContext& context, TetId t, int winner);

    std::uint32_t step_ = 1;
    core::Attribute<VertexId, Claim> claim_;
    core::Marks<TetId> seen_;
    Pinches pinches_;
    Foot foot_;
    std::vector<std::pair<TetId, int>> seeds_;  ///< with the label to be squeezed away
    std::vector<TetId> gap_;
    std::vector<VertexId> touched_;
    std::vector<VertexId> touched_in_step_;
    int characteristic_change_ = 0;  ///< of the interface: V - E + F
};

}  // namespace dsc::dsc3d
