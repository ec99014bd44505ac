// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/advance.h"

#include "tests/dsc3d/deform/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

struct Motion {
    explicit Motion(Mesh& mesh)
        : rated(mesh, geometry::QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh)),
          advance(mesh),
          target(mesh.complex().vertex_attributes(), Point3(Point3::Zero())) {
        for (const VertexId v : vertices(mesh.complex()))
            if (mesh.complex().is_interface(v) && !mesh.complex().is_boundary(v)) movers.push_back(v);
    }
    template <class Flow>
    void run(Flow&& flow, const AdvanceParameters& parameters) {
        for (const VertexId v : movers) target[v] = flow(rated.position(v));
        advance.run(rated, movers, target, parameters);
    }

    RatedMesh rated;
    Advance advance;
    core::Attribute<VertexId, Point3> target;
    std::vector<VertexId> movers;
};

}  // namespace

TEST_CASE("what moves rigidly arrives, exactly, with its volume") {
    Mesh mesh = box_with(distance_from_sphere({0.5, 0.6, 0.5}, 0.2), 0.12);
    Motion motion(mesh);
    const auto connectivity = labelled_tets(mesh.complex());
    const auto before = volumes(mesh);
    const Eigen::Affine3d turn = Eigen::Translation3d(0.5, 0.5, 0.5) *
                                 Eigen::AngleAxisd(0.05, Point3(1, 2, 3).normalized()) *
                                 Eigen::Translation3d(-0.5, -0.5, -0.5);
    for (int step = 0; step < 4; ++step) {
        motion.run([&](const Point3& p) { return Point3(turn * p); }, {.least_quality = 0.06, .carried_rings = 3});
        for (const VertexId v : motion.movers) REQUIRE(mesh.position(v) == motion.target[v]);
        require_valid(mesh);
        require_same(before, volumes(mesh), 1e-12);
        CHECK_FALSE(motion.advance.carried().empty());
    }
    CHECK(labelled_tets(mesh.complex()) == connectivity);
}

TEST_CASE("however wild the motion, no tetrahedron is inverted, or worse than the limit or than it was") {
    core::Random random(seed(1));
    const double least = 0.1;
    for (int trial = 0; trial < 24; ++trial) {
        Mesh mesh = box_with(distance_from_sphere({0.5, 0.6, 0.5}, 0.2), 0.17);
        Motion motion(mesh);
        const auto connectivity = labelled_tets(mesh.complex());
        const double reach = std::array{0.01, 0.1, 1.0, 100.0}[static_cast<std::size_t>(trial % 4)];
        for (int step = 0; step < 3; ++step) {
            const auto start = places(mesh);
            std::map<TetId, double> quality;
            for (const TetId t : tets(mesh.complex())) quality[t] = motion.rated.quality(t);
            motion.run(
                [&](const Point3& p) {
                    const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach),
                                 z = random.uniform(-reach, reach);
                    return Point3(p + Point3(x, y, z));
                },
                {.least_quality = least, .carried_rings = trial % 5});
            require_valid(mesh);
            const std::set<TetId> region(motion.advance.region().begin(), motion.advance.region().end());
            REQUIRE(region.size() == motion.advance.region().size());
            for (const TetId t : tets(mesh.complex())) {
                REQUIRE(motion.rated.quality(t) == motion.rated.rate(mesh.complex().vertices(t)));
                REQUIRE(motion.rated.quality(t) >= std::min(least, quality[t]));
            }
            const std::set<VertexId> movers(motion.movers.begin(), motion.movers.end());
            const std::set<VertexId> carried(motion.advance.carried().begin(), motion.advance.carried().end());
            REQUIRE((trial % 5 != 0 || carried.empty()));
            for (const VertexId v : carried) REQUIRE(motion.rated.surface().motion(v) != VertexMotion::fixed);
            for (const auto& [v, place] : start)
                if (movers.count(v) == 0 && carried.count(v) == 0) REQUIRE(mesh.position(v) == place);
            for (const TetId t : tets(mesh.complex())) {
                const TetVertices& corners = mesh.complex().vertices(t);
                if (std::any_of(corners.begin(), corners.end(),
                                [&](VertexId v) { return mesh.position(v) != start.at(v); }))
                    REQUIRE(region.count(t) == 1);
            }
        }
        CHECK(labelled_tets(mesh.complex()) == connectivity);
    }
}

TEST_CASE("what is pushed against the boundary of the domain goes on beside it, and stays inside") {
    Mesh mesh = box_with(distance_from_sphere({0.5, 0.6, 0.5}, 0.2), 0.15);
    Motion motion(mesh);
    double way = 0;
    for (int step = 0; step < 5; ++step) {
        const auto start = places(mesh);
        motion.run([](const Point3& p) { return Point3(p + Point3(0, 0.05, 0)); },
                   {.least_quality = 0.06, .carried_rings = 3});
        require_valid(mesh);
        for (const VertexId v : motion.movers) {
            REQUIRE(mesh.position(v).y() < 1);
            REQUIRE(mesh.position(v).y() >= start.at(v).y());
            REQUIRE((mesh.position(v) - start.at(v)).norm() <= 0.05 * (1 + 1e-12));
            way += mesh.position(v).y() - start.at(v).y();
        }
    }
    CHECK(way > 0.05 * static_cast<double>(motion.movers.size()));
}
