// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "dsc2d/generate/structured.h"
#include "dsc2d/operations/move_together.h"
#include "dsc2d/operations/move_vertex.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::tests::require_valid;

namespace {

VertexId vertex_at(const Complex& complex, const Point2& place) {
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v)
        if ((complex.position(VertexId(v)) - place).norm() < 1e-9) return VertexId(v);
    FAIL("no vertex there");
    return VertexId();
}

}  // namespace

TEST_CASE("a vertex goes to its target, or short of its link") {
    Complex complex = structured_complex(Domain::box({0, 0}, {4, 4}), 4, 4);
    const VertexId v = vertex_at(complex, {2, 2});
    const MoveResult near = move_vertex(complex, v, Point2(2.25, 2.125), {0.9, 0.5});
    CHECK(near.is_reached);
    CHECK(complex.position(v) == Point2(2.25, 2.125));
    const MoveResult far = move_vertex(complex, v, Point2(3.75, 2.125), {0.9, 0.5});
    CHECK_FALSE(far.is_reached);
    CHECK(complex.from(far.blocking) == v);
    CHECK(complex.position(v).y() == 2.125);
    CHECK(far.fraction == Approx(complex.position(v).x() / 1.5 - 1.5).epsilon(1e-9));
    require_valid(complex);
}

TEST_CASE("the motion of a vertex never flattens a face, however often it is repeated") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 3, 3);
    for (int i = 0; i < 300; ++i) {
        move_vertex(complex, VertexId(4), Point2(0.9, 0.95), {0.9, 0.5});
        require_valid(complex);
    }
}

TEST_CASE("all vertices translate together by any distance") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 4, 5);
    dsc::core::Attribute<VertexId, Point2> target(complex.vertex_attributes(), Point2(Point2::Zero()));
    std::vector<VertexId> vertices;
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v) {
        vertices.push_back(VertexId(v));
        target[VertexId(v)] = complex.domain().snapped(complex.position(VertexId(v)) + Point2(1.7, -2.3));
    }
    MoveTogether move(complex);
    move.run(complex, vertices, target);
    for (const VertexId v : vertices) {
        CHECK(move.is_moved(v));
        CHECK(complex.position(v) == target[v]);
    }
    require_valid(complex);
}

TEST_CASE("motion together holds back what would turn over, and nothing else") {
    Complex complex = structured_complex(Domain::torus(Eigen::Matrix2d::Identity()), 8, 8);
    dsc::core::Random random(dsc::tests::seed(12));
    dsc::core::Attribute<VertexId, Point2> target(complex.vertex_attributes(), Point2(Point2::Zero()));
    MoveTogether move(complex);
    std::size_t moved = 0, held = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<VertexId> vertices;
        for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v) {
            if (random.uniform() < 0.3) continue;
            const Point2 way(random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06));
            vertices.push_back(VertexId(v));
            target[VertexId(v)] = complex.domain().snapped(complex.position(VertexId(v)) + way);
        }
        move.run(complex, vertices, target);
        for (const VertexId v : vertices) ++(move.is_moved(v) ? moved : held);
        require_valid(complex);
    }
    CHECK(moved > 1000);
    CHECK(held > 1000);
}
