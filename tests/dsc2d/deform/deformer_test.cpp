// SPDX-License-Identifier: GPL-3.0-or-later
// What a deformer must not keep from step to step, and what it must not lose at the end of one.
#include <Eigen/Geometry>

#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/complex_around.h"
#include "dsc2d/generate/shapes.h"
#include "dsc2d/interface.h"
#include "tests/dsc2d/support.h"

using namespace dsc::dsc2d;
using dsc::tests::require_valid;
using dsc::tests::targets_of;
using std::numbers::pi;

TEST_CASE("a complex may be compacted between the steps of one deformer") {
    Complex complex = complex_around(Domain::box({-1, -1}, {1, 1}), slotted_disc({0, 0}, 0.5, 0.2, 0.6, 0.05), 0.05);
    Deformer deformer(complex, {.edge_length = 0.05});
    const double area = labelled_area(complex, 1);
    const Eigen::Rotation2Dd turn(2 * pi / 180);
    bool has_compacted = false;
    for (int step = 0; step < 45; ++step) {
        const StepReport report = deformer.step(targets_of(complex, [&](const Point2& p) { return Point2(turn * p); }));
        REQUIRE(report.is_complete);
        has_compacted = has_compacted || complex.garbage_fraction() > 0;
        complex.compact();
        require_valid(complex);
    }
    CHECK(has_compacted);
    CHECK(labelled_area(complex, 1) == Approx(area).epsilon(1e-13));
    const std::vector<InterfaceCurve> curves = interface_curves(complex);
    REQUIRE(curves.size() == 1);
    for (const Region& region : slotted_disc({0, 0}, 0.5, 0.2, 0.6, 0.05))
        for (const Point2& corner : region.outline) {
            double nearest = 1;
            for (const CurvePoint& point : curves[0].points)
                nearest = std::min(nearest, (point.place - Eigen::Rotation2Dd(pi / 2) * corner).norm());
            CHECK(nearest < 1e-12);
        }
}

TEST_CASE("vertices that are born after the motion of a step leave none of it over") {
    // Long sides whose ends are held: they are halved at the end of each step.
    Complex complex = complex_around(Domain::box({-1, -1}, {1, 1}), rectangle({0, 0}, {0.8, 0.8}, 0.2), 0.2);
    Parameters parameters = {.edge_length = 0.1};
    parameters.interface_max_edge = 1.6;
    Deformer deformer(complex, parameters);
    for (const VertexId v : Interface(complex).vertices) complex.lock(v);
    const StepReport report = deformer.step(targets_of(complex, [](const Point2& p) { return Point2(1.1 * p); }));
    REQUIRE(report.unfinished.size() == 16);
    for (const auto& motion : report.unfinished) CHECK(motion.is_locked);
    CHECK(report.is_complete);
}
