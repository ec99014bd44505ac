// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/improve/delaunay.h"

#include "dsc2d/operations/flip.h"
#include "geometry/predicates.h"

namespace dsc::dsc2d {

bool is_locally_delaunay(const Complex& complex, EdgeId e) {
    if (complex.is_boundary(e)) return true;
    const HalfedgeId h = Complex::halfedge(e);
    const Point2 b = complex.vector(h);
    const Point2 c = -complex.vector(complex.prev(h)), d = complex.vector(complex.next(Complex::opposite(h)));
    return geometry::in_circle(Point2::Zero(), b, c, d) != geometry::Sign::positive;
}

DelaunayPass::DelaunayPass(const Complex& complex) : is_queued_(complex.edge_attributes(), 0) {}

void DelaunayPass::push(EdgeId e) {
    if (is_queued_[e]) return;
    is_queued_[e] = 1;
    queue_.push_back(e);
}

std::size_t DelaunayPass::run(Complex& complex, std::span<const VertexId> active,
                              std::vector<VertexId>& touched) {
    for (const VertexId v : active) {
        if (complex.is_deleted(v)) continue;
        for (const HalfedgeId h : complex.outgoing(v)) {
            push(Complex::edge(h));
            if (!complex.is_boundary(h)) push(Complex::edge(complex.next(h)));
        }
    }
    return empty_queue(complex, touched);
}

std::size_t DelaunayPass::run_everywhere(Complex& complex) {
    for (std::uint32_t e = 0; e < complex.edge_capacity(); ++e)
        if (!complex.is_deleted(EdgeId(e))) push(EdgeId(e));
    std::vector<VertexId> touched;
    return empty_queue(complex, touched);
}

std::size_t DelaunayPass::empty_queue(Complex& complex, std::vector<VertexId>& touched) {
    std::size_t flips = 0;
    while (!queue_.empty()) {
        const EdgeId e = queue_.back();
        queue_.pop_back();
        is_queued_[e] = 0;
        if (complex.is_interface(e) || is_locally_delaunay(complex, e) || !can_flip(complex, e)) continue;
        flip(complex, e);
        ++flips;
        const HalfedgeId h = Complex::halfedge(e), o = Complex::opposite(h);
        for (const HalfedgeId side : {complex.next(h), complex.prev(h), complex.next(o), complex.prev(o)})
            push(Complex::edge(side));
        touched.push_back(complex.from(h));
        touched.push_back(complex.to(h));
    }
    return flips;
}

}  // namespace dsc::dsc2d
