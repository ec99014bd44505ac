// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/options.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "apps/flow/options.h"
#include "core/errors.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using flow::planar::Motion;
using flow::planar::Point2;
using flow::planar::Shape;

namespace {

flow::Options parsed(std::vector<std::string> arguments) {
    const tests::TemporaryFolder folder;
    arguments.insert(arguments.begin(), "flow");
    arguments.insert(arguments.end(), {"--dimension", "2", "-o", folder.path().string()});
    std::vector<const char*> argv;
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    return *flow::parse_options(static_cast<int>(argv.size()), argv.data());
}

void check_options_refused(const std::vector<std::string>& arguments, const std::string& word) {
    CAPTURE(arguments);
    CHECK_THROWS_AS(parsed(arguments), core::UsageError);
    CHECK_THROWS_WITH(parsed(arguments), Catch::Contains(word));
}

}  // namespace

TEST_CASE("points of the plane have two coordinates, shapes and motions their own names") {
    const flow::Options options =
        parsed({"ring",          "--center", "1,-2",     "--radius", "0.4",        "--minor-radius", "0.2",
                "--edge-length", "0.05",     "--domain", "0,-5,2,4", "--torus",    "--motion",       "rotate",
                "--about",       "3,4",      "--angle",  "-90",      "--topology", "merge-only"});
    REQUIRE(options.planar);
    const flow::planar::ShapeOptions& shape = options.planar->shape;
    CHECK(shape.shape == Shape::ring);
    CHECK(shape.centre == Point2(1, -2));
    CHECK(*shape.radius == 0.4);
    CHECK(*shape.minor_radius == 0.2);
    CHECK(*shape.edge_length == 0.05);
    CHECK(shape.domain->min() == Point2(0, -5));
    CHECK(shape.domain->max() == Point2(2, 4));
    CHECK(shape.is_torus);
    CHECK(*options.planar->motion.about == Point2(3, 4));
    CHECK(options.planar->motion.angle == -90);
    CHECK(options.topology == motion::TopologyPolicy::merge_only);

    CHECK(*parsed({"box", "--size", "2"}).planar->shape.size == Point2(2, 2));
    CHECK(*parsed({"labelled-block", "--size", "2,3"}).planar->shape.size == Point2(2, 3));
    CHECK(parsed({"polygon", "--sides", "5"}).planar->shape.sides == 5);
    CHECK(parsed({"logo.svg"}).planar->shape.path == "logo.svg");
    CHECK(parsed({"disc", "--motion", "translate", "--velocity", "1,-0.5"}).planar->motion.velocity == Point2(1, -0.5));
    const flow::Options words = parsed({"disc", "--motion", "expression", "--velocity", "(-y, x)"});
    CHECK(words.planar->motion.motion == Motion::expression);
    CHECK(words.planar->motion.expressions == "(-y, x)");
}

TEST_CASE("what the plane does not have, or has no use for, is refused by name") {
    check_options_refused({"sphere"}, "shape of the plane");
    check_options_refused({"disc", "--motion", "enright"}, "enright");
    check_options_refused({"disc", "--axis", "0,0,1"}, "--axis");
    check_options_refused({"disc", "--center", "1,2,3"}, "--center");
    check_options_refused({"disc", "--about", "x,1"}, "--about");
    check_options_refused({"disc", "--domain", "0,0,0,1,1,1"}, "--domain");
    check_options_refused({"disc", "--domain", "0,0,1,0"}, "--domain");
    check_options_refused({"box", "--size", "1,2,3"}, "--size");
    check_options_refused({"box", "--size", "0"}, "--size");
    check_options_refused({"disc", "--gap", "1"}, "--gap");
    check_options_refused({"disc", "--sides", "5"}, "--sides");
    check_options_refused({"polygon", "--sides", "2"}, "--sides");
    check_options_refused({"logo.svg", "--radius", "1"}, "--radius");
    check_options_refused({"disc", "--motion", "offset"}, "--distance");
    check_options_refused({"disc", "--motion", "translate"}, "--velocity");
    check_options_refused({"disc", "--motion", "translate", "--velocity", "1,0,0"}, "--velocity");
    check_options_refused({"disc", "--motion", "expression"}, "--velocity");
    check_options_refused({"disc", "--motion", "curvature", "--angle", "5"}, "--angle");
    check_options_refused({"disc", "--dt", "0.1", "--until", "1", "--steps", "10"}, "--steps");
    check_options_refused({"disc", "--motion", "grid"}, "--velocity");
    const std::vector<const char*> spatial = {"flow", "sphere", "--torus", "-o", "."};
    CHECK_THROWS_WITH(flow::parse_options(5, spatial.data()), Catch::Contains("--torus"));
}
