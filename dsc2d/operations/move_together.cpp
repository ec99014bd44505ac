// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/operations/move_together.h"

namespace dsc::dsc2d {

MoveTogether::MoveTogether(const Complex& complex) : is_moving_(complex.vertex_attributes(), 0) {}

void MoveTogether::forget() {
    for (const VertexId v : moved_before_) is_moving_[v] = 0;
    moved_before_.clear();
}

void MoveTogether::run(Complex& complex, std::span<const VertexId> vertices,
                       const core::Attribute<VertexId, Point2>& target) {
    forget();
    moved_before_.assign(vertices.begin(), vertices.end());
    for (const VertexId v : vertices) is_moving_[v] = 1;

    const auto shift = [&](VertexId v) {
        return is_moving_[v] ? Point2(target[v] - complex.position(v)) : Point2(Point2::Zero());
    };
    // A vertex that is held back turns its neighbours' faces into other ones: they are judged again.
    to_judge_.assign(vertices.rbegin(), vertices.rend());
    while (!to_judge_.empty()) {
        const VertexId v = to_judge_.back();
        to_judge_.pop_back();
        const HalfedgeId first = complex.halfedge(v);
        HalfedgeId h = first;
        Point2 start = shift(v);
        Point2 u = complex.vector(h) + shift(complex.to(h));
        do {
            const HalfedgeId following = complex.rotated(h);
            const Point2 w = complex.vector(following) + shift(complex.to(following));
            if (!geometry::is_counterclockwise(start, u, w)) {
                for (const VertexId corner : {v, complex.to(h), complex.to(following)}) {
                    if (!is_moving_[corner]) continue;
                    is_moving_[corner] = 0;
                    to_judge_.push_back(corner);
                }
                start = shift(v);
                u = complex.vector(following) + shift(complex.to(following));
            } else {
                u = w;
            }
            h = following;
        } while (h != first);
    }
    for (const VertexId v : vertices)
        if (is_moving_[v]) complex.set_position_unchecked(v, target[v]);
}

}  // namespace dsc::dsc2d
