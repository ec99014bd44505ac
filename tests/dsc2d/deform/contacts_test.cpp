// SPDX-License-Identifier: GPL-3.0-or-later
// Regions that are squeezed until nothing is left of them.
#include "dsc2d/deform/contacts.h"

#include "dsc2d/curve/edge_offsetting.h"
#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/complex_around.h"
#include "dsc2d/generate/shapes.h"
#include "dsc2d/interface.h"
#include "dsc2d/label_statistics.h"
#include "geometry/triangle.h"
#include "tests/dsc2d/support.h"

using namespace dsc::dsc2d;
using dsc::motion::TopologyPolicy;
using dsc::tests::min_angle;
using dsc::tests::require_valid;
using dsc::tests::targets_of;
using std::numbers::pi;

TEST_CASE("a region that shrinks to a single face is stopped where topology is preserved, and vanishes elsewhere") {
    for (const TopologyPolicy policy : {TopologyPolicy::preserved, TopologyPolicy::adaptive}) {
        Complex complex = complex_around(Domain::box({-1, -1}, {1, 1}), disc({0, 0}, 0.2, 0.05), 0.05);
        Parameters parameters = {.edge_length = 0.05, .topology = policy};
        parameters.interface_max_edge = 1.6;
        parameters.interface_min_edge = 0.4;
        Deformer deformer(complex, parameters);
        std::size_t contacts = 0;
        for (int step = 0; step < 60; ++step) {
            const double radius = 0.2 - 0.005 * step;
            contacts += deformer
                            .step(targets_of(complex,
                                             [&](const Point2& p) {
                                                 return p.norm() > 0 && radius > 0 ? Point2(p * (radius / p.norm()))
                                                                                   : Point2(Point2::Zero());
                                             }))
                            .contacts.size();
            require_valid(complex);
        }
        const auto labels = label_statistics(complex);
        if (policy == TopologyPolicy::adaptive) {
            CHECK(labels.size() == 1);
        } else {
            REQUIRE(labels.size() == 2);
            CHECK(labels[1].components == 1);
            CHECK(labels[1].triangles >= 1);
            CHECK(labels[1].area > 1e-3 * 0.05 * 0.05);
            CHECK(contacts > 0);
        }
    }
}

TEST_CASE("a neck that is squeezed by more than its width falls apart in the same step, mesh inside it or not") {
    for (const double edge_length : {0.025, 0.0125}) {
        Complex complex =
            complex_around(Domain::box({-1.2, -0.5}, {1.2, 0.5}), dumbbell({0, 0}, {}, edge_length), edge_length);
        Parameters parameters = {.edge_length = edge_length, .topology = TopologyPolicy::split_only};
        parameters.interface_max_edge = 1.6;
        parameters.interface_min_edge = 0.4;
        parameters.poor_angle = 25 * pi / 180;
        parameters.needle_angle = 20 * pi / 180;
        parameters.smoothing_sweeps = 2;
        Deformer deformer(complex, parameters);
        const auto steps_to_zero = std::lround(0.2 / edge_length);
        for (int step = 0; step < steps_to_zero; ++step) {
            REQUIRE(label_statistics(complex)[1].components == 1);
            const Interface interface(complex);
            const auto steps = offset_displacements(interface, -edge_length / 2, {});
            std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
            for (std::size_t i = 0; i < steps.size(); ++i)
                targets[interface.vertices[i].index()] = complex.position(interface.vertices[i]) + steps[i];
            REQUIRE(deformer.step(targets).is_complete);
            require_valid(complex);
            CHECK(min_angle(complex) > 8 * pi / 180);
        }
        CHECK(label_statistics(complex)[1].components == 2);
    }
}
