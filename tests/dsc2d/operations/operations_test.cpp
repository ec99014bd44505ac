// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include "core/random.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "dsc2d/operations/collapse.h"
#include "dsc2d/operations/flip.h"
#include "dsc2d/operations/move_vertex.h"
#include "dsc2d/operations/split.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::tests::require_valid;

namespace {

struct Tally {
    int flips = 0, label_flips = 0, edge_splits = 0, face_splits = 0, collapses = 0, moves = 0, labels = 0;
};

class RandomOperations {
public:
    RandomOperations(Complex& complex, std::uint64_t seed, std::uint32_t size)
        : complex_(complex), random_(seed), size_(size) {}

    // Returns false when what was drawn was not possible.
    bool run_one(Tally& tally) {
        const HalfedgeId h = random_halfedge();
        const bool is_small = complex_.vertex_count() < size_;
        switch (random_.below(8)) {
            case 0:
            case 1:
                if (complex_.is_interface(h) || !can_flip(complex_, Complex::edge(h))) return false;
                flip(complex_, Complex::edge(h));
                ++tally.flips;
                return true;
            case 2:
                if (!complex_.is_interface(h) || !can_flip(complex_, Complex::edge(h))) return false;
                flip_to_label_of(complex_, h);
                ++tally.label_flips;
                return true;
            case 3: {
                // Vertices of the boundary never go again: too many of them would leave no room for the others.
                if (complex_.is_boundary(Complex::edge(h)) && random_.uniform() < 0.9995) return false;
                const auto place = is_small ? can_split_edge(complex_, h, random_.uniform(0.05, 0.95)) : std::nullopt;
                if (!place) return false;
                split_edge(complex_, h, *place);
                ++tally.edge_splits;
                return true;
            }
            case 4: {
                if (!is_small || complex_.is_boundary(h)) return false;
                const Point2 way = 0.3 * complex_.vector(h) - 0.4 * complex_.vector(complex_.prev(h));
                const Point2 place = complex_.domain().snapped(complex_.position(complex_.from(h)) + way);
                if (!can_split_face(complex_, h, place)) return false;
                split_face(complex_, h, place);
                ++tally.face_splits;
                return true;
            }
            case 5: {
                const auto rule = static_cast<CollapseRule>(random_.below(3));
                if (!can_collapse(complex_, h, rule)) return false;
                collapse(complex_, h);
                ++tally.collapses;
                return true;
            }
            case 6: {
                if (complex_.is_boundary(complex_.from(h))) return false;
                const Point2 target = complex_.domain().snapped(
                    complex_.position(complex_.from(h)) + Point2(random_.uniform(-0.3, 0.3), random_.uniform(-0.3, 0.3)));
                if (!complex_.domain().is_in_reach(target)) return false;
                move_vertex(complex_, complex_.from(h), target, {0.9, 0.5});
                ++tally.moves;
                return true;
            }
            default:
                if (complex_.is_boundary(h)) return false;
                complex_.set_label(complex_.face(h), static_cast<int>(random_.below(3)));
                ++tally.labels;
                return true;
        }
    }

private:
    HalfedgeId random_halfedge() {
        while (true) {
            const HalfedgeId h(static_cast<std::uint32_t>(random_.below(2 * complex_.edge_capacity())));
            if (!complex_.is_deleted(Complex::edge(h))) return h;
        }
    }

    Complex& complex_;
    dsc::core::Random random_;
    std::uint32_t size_;
};

void run_random_operations(const Domain& domain, int operations, std::uint64_t seed) {
    Complex complex = structured_complex(domain, 4, 4);
    RandomOperations random_operations(complex, seed, 60);
    Tally tally;
    int done = 0;
    while (done < operations) {
        if (!random_operations.run_one(tally)) continue;
        ++done;
        require_valid(complex);
        if (std::abs(total_area(complex) - domain.area()) > 1e-12 * domain.area()) FAIL("the area of the domain changed");
        if (complex.garbage_fraction() > 0.5) complex.compact();
    }
    for (const int count : {tally.flips, tally.label_flips, tally.edge_splits, tally.face_splits, tally.collapses,
                            tally.moves, tally.labels})
        CHECK(count > operations / 100);
}

}  // namespace

TEST_CASE("100000 random operations on a box, each followed by a full check", "[slow]") {
    run_random_operations(Domain::box({0, 0}, {1, 1}), 100000, dsc::tests::seed(8));
}

TEST_CASE("100000 random operations on a torus, each followed by a full check", "[slow]") {
    Eigen::Matrix2d periods;
    periods << 1.0, 0.31, 0.07, 0.9;
    run_random_operations(Domain::torus(periods), 100000, dsc::tests::seed(9));
}

TEST_CASE("random operations on a cylinder, each followed by a full check") {
    run_random_operations(Domain::cylinder({1, 0}, {0, 1}), 20000, dsc::tests::seed(10));
}

TEST_CASE("a flip of a flip is the edge that was there") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 4, 4);
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        const EdgeId e(i);
        if (!can_flip(complex, e)) continue;
        const HalfedgeId h = Complex::halfedge(e);
        const Point2 vector = complex.vector(h);
        const VertexId from = complex.from(h);
        flip(complex, e);
        CHECK(complex.vector(h) != vector);
        flip(complex, e);
        CHECK(complex.vector(h) == -vector);
        CHECK(complex.to(h) == from);
        flip(complex, e);
        flip(complex, e);
        CHECK(complex.vector(h) == vector);
    }
    require_valid(complex);
}

TEST_CASE("splits inherit the label and the interface") {
    Complex complex = structured_complex(Domain::box({0, 0}, {1, 1}), 6, 6);
    insert_polygon(complex, dsc::tests::circle({0.5, 0.5}, 0.3, 8), 1);
    const double inside = labelled_area(complex, 1);
    for (std::uint32_t i = 0, count = complex.edge_capacity(); i < count; ++i) {
        const bool was_interface = complex.is_interface(EdgeId(i));
        const HalfedgeId h = Complex::halfedge(EdgeId(i));
        const auto place = can_split_edge(complex, h, 0.5);
        if (!place) continue;
        const VertexId m = split_edge(complex, h, *place);
        CHECK(complex.interface_degree(m) == (was_interface ? 2 : 0));
    }
    require_valid(complex);
    CHECK(labelled_area(complex, 1) == Approx(inside).epsilon(1e-12));
}

TEST_CASE("the collapse rules protect the interface") {
    Complex complex = structured_complex(Domain::box({0, 0}, {1, 1}), 6, 6);
    const auto front = insert_polygon(complex, dsc::tests::circle({0.5, 0.5}, 0.3, 8), 1);
    const double inside = labelled_area(complex, 1);
    complex.lock(front[3]);
    bool coarsened = false;
    for (const VertexId v : front)
        for (const HalfedgeId h : complex.outgoing(v)) {
            CHECK_FALSE(can_collapse(complex, h, CollapseRule::keep_interface));
            if (can_collapse(complex, h, CollapseRule::coarsen_interface)) {
                CHECK(complex.is_interface(h));
                coarsened = true;
            }
            if (v == front[3]) CHECK_FALSE(can_collapse(complex, h, CollapseRule::change_topology));
        }
    CHECK(coarsened);
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        const HalfedgeId h = Complex::halfedge(EdgeId(i));
        if (complex.is_deleted(EdgeId(i)) || !can_collapse(complex, h, CollapseRule::keep_interface)) continue;
        collapse(complex, h);
        require_valid(complex);
    }
    CHECK(labelled_area(complex, 1) == Approx(inside).epsilon(1e-13));
}
