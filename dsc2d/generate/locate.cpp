// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/generate/locate.h"

#include "core/errors.h"
#include "core/random.h"
#include "dsc2d/operations/split.h"

namespace dsc::dsc2d {

std::optional<Location> locate(const Complex& complex, const Point2& point) {
    using geometry::Sign;
    std::uint32_t first = 0;
    while (complex.is_deleted(FaceId(first))) ++first;
    HalfedgeId h = complex.halfedge(FaceId(first));
    LatticeVector cell = LatticeVector::Zero();
    core::Random random(1);
    const auto step_to_next = [&] {
        cell += complex.offset(h);
        h = complex.next(h);
    };
    while (true) {
        if (random.below(2) == 1) step_to_next();
        std::array<Sign, 3> side{};
        bool is_crossed = false;
        for (std::size_t i = 0; i < 3 && !is_crossed; ++i) {
            const Point2 a = complex.position(complex.from(h)) + complex.domain().translation(cell);
            side[i] = geometry::orientation(a, a + complex.vector(h), point);
            if (side[i] == Sign::negative) {
                cell += complex.offset(h);
                h = Complex::opposite(h);
                if (complex.is_boundary(h)) return std::nullopt;
                is_crossed = true;
            } else {
                step_to_next();
            }
        }
        if (is_crossed) continue;
        // h is back at the first side tried.
        const int zero_sides = (side[0] == Sign::zero) + (side[1] == Sign::zero) + (side[2] == Sign::zero);
        if (zero_sides == 0) return Location{h, cell, 0};
        // On one side: turn until it is h. At a corner: turn until the two zero sides are prev(h) and h.
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_zero = side[i] == Sign::zero, was_zero = side[(i + 2) % 3] == Sign::zero;
            if (is_zero && (zero_sides == 1 || was_zero)) return Location{h, cell, zero_sides};
            step_to_next();
        }
    }
}

CoverVertex insert_point(Complex& complex, const Point2& point) {
    if (!complex.domain().is_in_reach(point))
        throw core::InputError("point", "", "lies far outside the domain", "use coordinates near the domain");
    const std::optional<Location> location = locate(complex, point);
    if (!location) throw core::InputError("point", "", "lies outside the domain", "enlarge the box");
    const auto [h, cell, zero_sides] = *location;
    if (zero_sides == 2) {
        if (complex.is_boundary(complex.from(h)))
            throw core::InputError("point", "", "lies on the boundary of the domain", "enlarge the box");
        return {complex.from(h), cell};
    }
    if (zero_sides == 1 && complex.is_boundary(Complex::edge(h)))
        throw core::InputError("point", "", "lies on the boundary of the domain", "enlarge the box");
    const Point2 place = point - complex.domain().translation(cell);
    const VertexId v = zero_sides == 1 ? split_edge(complex, h, place) : split_face(complex, h, place);
    complex.reanchor(v, cell);
    return {v, LatticeVector::Zero()};
}

}  // namespace dsc::dsc2d
