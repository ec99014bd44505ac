// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/deform/parameters.h"

#include "core/errors.h"
#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/structured.h"
#include "tests/dsc2d/support.h"

using namespace dsc::dsc2d;
using dsc::core::UsageError;

TEST_CASE("parameters are valid but for the edge length, which has no default") {
    Parameters parameters;
    CHECK_THROWS_WITH(parameters.validate(), Catch::Contains("edge_length"));
    parameters.edge_length = 0.1;
    CHECK_NOTHROW(parameters.validate());
    parameters.approach = 1.0;
    CHECK_THROWS_WITH(parameters.validate(), Catch::Contains("approach"));
    parameters.approach = 0.9;
    parameters.flips_on_the_way = -1;
    CHECK_THROWS_WITH(parameters.validate(), Catch::Contains("flips_on_the_way"));
    parameters.flips_on_the_way = 16;
    parameters.interface_min_edge = 0.6;
    parameters.interface_max_edge = 1.0;
    CHECK_THROWS_WITH(parameters.validate(), Catch::Contains("interface_min_edge"));
}

TEST_CASE("targets that can't be are refused before anything moves") {
    Complex complex = structured_complex(Domain::box({0, 0}, {1, 1}), 4, 4);
    Parameters parameters;
    parameters.edge_length = 0.1;
    Deformer deformer(complex, parameters);
    std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
    const auto refused = [&](VertexId v, const Point2& target) {
        targets.assign(complex.vertex_capacity(), std::nullopt);
        targets[v.index()] = target;
        CHECK_THROWS_AS(deformer.step(targets), UsageError);
    };
    VertexId inner;
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v)
        if (!complex.is_boundary(VertexId(v))) inner = VertexId(v);
    refused(VertexId(0), {0.5, 0.5});
    refused(inner, {1e6, 0});
    refused(inner, {std::nan(""), 0});
    targets.assign(complex.vertex_capacity() + 1, std::nullopt);
    CHECK_THROWS_AS(deformer.step(targets), UsageError);

    targets.assign(complex.vertex_capacity(), std::nullopt);
    const Point2 goal = complex.domain().snapped(complex.position(inner) + Point2(0.05, 0.05));
    targets[inner.index()] = goal;
    complex.lock(inner);
    const StepReport held = deformer.step(targets);
    REQUIRE(held.unfinished.size() == 1);
    CHECK(held.unfinished[0].is_locked);
    CHECK(held.is_complete);
    complex.unlock(inner);
    CHECK(deformer.step(targets).is_complete);
}
