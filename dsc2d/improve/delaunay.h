// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay flips away from the interface, by Lawson's queue.
// Source: thesis 4.3.1; Lawson (1977). Guarantee: exact predicates, so the pass ends, and every edge it looked at is locally Delaunay, on the interface, or not flippable. Cost: linear in active edges and flips; no
// allocation once the buffers have grown.
#pragma once

#include <span>
#include <vector>

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

/// True when e is on the domain's boundary, or the apex of neither of its faces lies inside the other's circumcircle.
bool is_locally_delaunay(const Complex& complex, EdgeId e);

class DelaunayPass {
public:
    explicit DelaunayPass(const Complex& complex);

    /// Flips what is not Delaunay among the edges at and around the active vertices, and what these flips disturb.
    /// Returns the number of flips; the ends of flipped edges are appended to `touched` (may repeat).
    std::size_t run(Complex& complex, std::span<const VertexId> active, std::vector<VertexId>& touched);
    /// The same for the whole complex.
    std::size_t run_everywhere(Complex& complex);

private:
    void push(EdgeId e);
    std::size_t empty_queue(Complex& complex, std::vector<VertexId>& touched);

    std::vector<EdgeId> queue_;
    core::Attribute<EdgeId, std::uint8_t> is_queued_;
};

}  // namespace dsc::dsc2d
