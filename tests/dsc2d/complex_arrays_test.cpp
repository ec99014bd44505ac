// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/complex_arrays.h"

#include <algorithm>
#include <array>

#include "core/errors.h"
#include "core/random.h"
#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "dsc2d/operations/collapse.h"
#include "dsc2d/operations/flip.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::tests::require_valid;

namespace {

void check_same(const ComplexArrays& a, const ComplexArrays& b) {
    CHECK(a.outgoing == b.outgoing);
    CHECK(a.positions == b.positions);
    CHECK(a.is_locked == b.is_locked);
    CHECK(a.ends == b.ends);
    CHECK(a.next == b.next);
    CHECK(a.faces == b.faces);
    CHECK(a.offsets == b.offsets);
    CHECK(a.halfedges == b.halfedges);
    CHECK(a.labels == b.labels);
}

// Collapses many edges, so that there are deleted elements.
void thin_out(Complex& complex, dsc::core::Random& random) {
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v) {
        if (random.below(2) == 0 || complex.is_deleted(VertexId(v))) continue;
        for (const HalfedgeId h : complex.outgoing(VertexId(v)))
            if (can_collapse(complex, h, CollapseRule::keep_interface)) {
                collapse(complex, h);
                break;
            }
    }
}

// Carries the circle to the right.
StepReport moved(Complex& complex) {
    Deformer deformer(complex, {.edge_length = 0.1});
    std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v)
        if (!complex.is_deleted(VertexId(v)) && complex.is_interface(VertexId(v)))
            targets[v] = complex.position(VertexId(v)) + Point2(0.07, 0.01);
    return deformer.step(targets);
}

}  // namespace

TEST_CASE("a complex made again from its arrays has the same handles, and goes the same way") {
    dsc::core::Random random(dsc::tests::seed(3));
    for (const bool is_torus : {false, true}) {
        const Domain domain = is_torus ? Domain::torus(Eigen::Matrix2d::Identity()) : Domain::box({0, 0}, {1, 1});
        Complex complex = structured_complex(domain, 12, 10);
        insert_polygon(complex, dsc::tests::circle({0.4, 0.5}, 0.2, 16), 2);
        thin_out(complex, random);
        REQUIRE(complex.garbage_fraction() > 0.1);
        complex.lock(VertexId(complex.vertex_capacity() - 1));
        const ComplexArrays arrays = complex.arrays();
        Complex again(domain, arrays);
        require_valid(again);
        check_same(again.arrays(), arrays);
        CHECK(again.vertex_count() == complex.vertex_count());
        CHECK(again.face_count() == complex.face_count());
        for (int step = 0; step < 3; ++step) {
            CHECK(moved(again).counts.flips == moved(complex).counts.flips);
            check_same(again.arrays(), complex.arrays());
            if (step == 1) {
                again.compact();
                complex.compact();
            }
        }
        require_valid(again);
    }
}

TEST_CASE("vertices that are joined by several edges are kept apart by their lattice vectors") {
    const Domain torus = Domain::torus(Eigen::Matrix2d::Identity());
    Complex coarse = structured_complex(torus, 3, 3);
    // Longer and longer edges, until two of them have the same ends.
    const auto has_double_edges = [&] {
        std::vector<std::array<std::uint32_t, 2>> ends;
        for (std::uint32_t e = 0; e < coarse.edge_capacity(); ++e) {
            if (coarse.is_deleted(EdgeId(e))) continue;
            const HalfedgeId h = Complex::halfedge(EdgeId(e));
            const auto [low, high] = std::minmax({coarse.from(h).index(), coarse.to(h).index()});
            ends.push_back({low, high});
        }
        std::ranges::sort(ends);
        return std::ranges::adjacent_find(ends) != ends.end();
    };
    dsc::core::Random random(dsc::tests::seed(5));
    for (int i = 0; i < 1000 && !has_double_edges(); ++i) {
        const EdgeId e(static_cast<std::uint32_t>(random.below(coarse.edge_capacity())));
        if (can_flip(coarse, e)) flip(coarse, e);
    }
    REQUIRE(has_double_edges());
    require_valid(coarse);
    const Complex again(torus, coarse.arrays());
    require_valid(again);
    check_same(again.arrays(), coarse.arrays());
}

TEST_CASE("arrays that can't be those of a complex are refused") {
    const Domain box = Domain::box({0, 0}, {1, 1});
    const ComplexArrays arrays = structured_complex(box, 2, 2).arrays();
    const auto check_refused = [&](auto&& change) {
        ComplexArrays changed = arrays;
        change(changed);
        CHECK_THROWS_AS(Complex(box, changed), dsc::core::InputError);
    };
    check_refused([](ComplexArrays& a) { a.outgoing.pop_back(); });
    check_refused([](ComplexArrays& a) { a.is_locked.clear(); });
    check_refused([](ComplexArrays& a) { a.ends.push_back(0); });
    check_refused([](ComplexArrays& a) { a.next[0] = 1000; });
    check_refused([](ComplexArrays& a) { a.faces[0] = 1000; });
    check_refused([](ComplexArrays& a) { a.ends[3] = ComplexArrays::none; });
    check_refused([](ComplexArrays& a) { a.halfedges[0] = 1000; });
}
