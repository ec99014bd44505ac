// SPDX-License-Identifier: GPL-3.0-or-later
// Motion of many vertices at once, as far as that inverts nothing. Neighbours on a smooth front keep each other from
// moving when they go one after another, because the faces between them turn over on the way; together they don't.
// Source: not in the thesis; what it leaves goes through algorithm 5. Guarantee: one operation: the final faces are all
// judged exactly before anything moves. As incidence stays and all faces stay strictly counterclockwise, the complex
// remains an embedding: no part of the interface can pass another. Cost: linear in the stars of the vertices.
#pragma once

#include <span>
#include <vector>

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

class MoveTogether {
public:
    explicit MoveTogether(const Complex& complex);

    /// Moves a subset of `vertices` to their targets (on the grid): all but those at a face that would turn over, and
    /// those that then can't move either. True for v in is_moved() until the next run. Precondition: no vertex is on
    /// the boundary, each occurs once.
    void run(Complex& complex, std::span<const VertexId> vertices, const core::Attribute<VertexId, Point2>& target);
    bool is_moved(VertexId v) const { return is_moving_[v] != 0; }
    /// Ends the validity of is_moved(); needed before the complex is compacted.
    void forget();

private:
    core::Attribute<VertexId, std::uint8_t> is_moving_;
    std::vector<VertexId> moved_before_;
    std::vector<VertexId> to_judge_;
};

}  // namespace dsc::dsc2d
