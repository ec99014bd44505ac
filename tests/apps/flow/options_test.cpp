// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/options.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "apps/flow/passes.h"
#include "core/errors.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow;

namespace {

std::optional<Options> parsed(std::vector<std::string> arguments) {
    const tests::TemporaryFolder folder;
    arguments.insert(arguments.begin(), "flow");
    arguments.insert(arguments.end(), {"-o", folder.path().string()});
    std::vector<const char*> argv;
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    return parse_options(static_cast<int>(argv.size()), argv.data());
}

void check_options_refused(const std::vector<std::string>& arguments, const std::string& word) {
    CAPTURE(arguments);
    CHECK_THROWS_AS(parsed(arguments), core::UsageError);
    CHECK_THROWS_WITH(parsed(arguments), Catch::Contains(word));
}

}  // namespace

TEST_CASE("options of shape, motion and time arrive as numbers") {
    const Options options = *parsed(
        {"torus", "--center", "1,2,-3.5",     "--radius", "0.4",    "--minor-radius", "0.2",        "--edge-length",
         "0.05",  "--domain", "0,0,-5,2,4,0", "--motion", "rotate", "--axis",         "0,1,1",      "--about",
         "1,1,1", "--angle",  "-90",          "--steps",  "25",     "--topology",     "merge-only", "--snapshots",
         "0"});
    CHECK(options.shape.shape == Shape::torus);
    CHECK(options.shape.centre == Point3(1, 2, -3.5));
    CHECK(*options.shape.radius == 0.4);
    CHECK(*options.shape.minor_radius == 0.2);
    CHECK(*options.shape.edge_length == 0.05);
    CHECK(options.shape.domain->min() == Point3(0, 0, -5));
    CHECK(options.shape.domain->max() == Point3(2, 4, 0));
    CHECK(options.motion.motion == Motion::rotate);
    CHECK(options.motion.axis == Point3(0, 1, 1));
    CHECK(*options.motion.about == Point3(1, 1, 1));
    CHECK(options.motion.angle == -90);
    CHECK(*options.time.steps == 25);
    CHECK_FALSE(options.time.dt);
    CHECK(options.topology == dsc::motion::TopologyPolicy::merge_only);
    CHECK(options.snapshots == 0);
    CHECK(options.given["--angle"].string() == "-90");
}

TEST_CASE("a domain is a box or a ball") {
    const Options around = *parsed({"sphere", "--domain", "sphere:1,2,-3,0.5"});
    CHECK_FALSE(around.shape.domain);
    CHECK(around.shape.sphere->centre == Point3(1, 2, -3));
    CHECK(around.shape.sphere->radius == 0.5);
    CHECK(parsed({"sphere", "--domain", "sphere:0.7"})->shape.sphere->centre == Point3(0.5, 0.5, 0.5));
    CHECK(parsed({"sphere", "--domain", "vessel.stl"})->shape.container == "vessel.stl");
    CHECK(parsed({"sphere"})->shape.container.empty());
    for (const char* text : {"sphere:", "sphere:1,2", "sphere:1,2,3,-1", "sphere:0"})
        check_options_refused({"sphere", "--domain", text}, "--domain");
}

TEST_CASE("a shape that is not known by name is a file; --velocity is what the motion makes of it") {
    const Options file = *parsed({"ball.off", "--motion", "offset", "--distance", "-0.1"});
    CHECK(file.shape.shape == Shape::file);
    CHECK(file.shape.path == "ball.off");
    CHECK(*file.motion.distance == -0.1);
    CHECK(*parsed({"box", "--size", "2", "--motion", "translate", "--velocity", "1,0,0"})->motion.velocity ==
          Point3(1, 0, 0));
    const std::string text = "(-y, x, t)";
    CHECK(*parsed({"box", "--size", "1,2,3", "--motion", "expression", "--velocity", text})->motion.expressions ==
          text);
}

TEST_CASE("curl noise, shear and velocities from a file have options of their own") {
    const Options noise =
        *parsed({"sphere", "--motion", "curl-noise", "--speed", "2", "--frequency", "4", "--seed", "9"});
    CHECK(noise.motion.motion == Motion::curl_noise);
    CHECK(noise.motion.speed == 2);
    CHECK(noise.motion.frequency == 4);
    CHECK(noise.motion.seed == 9);
    const Options shear =
        *parsed({"sphere", "--motion", "shear", "--direction", "0,0,2", "--gradient", "1,0,0", "--about", "0,1,2"});
    CHECK(shear.motion.direction == Point3(0, 0, 2));
    CHECK(shear.motion.gradient == Point3(1, 0, 0));
    CHECK(*shear.motion.about == Point3(0, 1, 2));
    const Options grid = *parsed({"sphere", "--motion", "grid", "--velocity", "wind.vti", "--array", "wind"});
    CHECK(grid.motion.path == "wind.vti");
    CHECK(grid.motion.array == "wind");
    check_options_refused({"sphere", "--motion", "grid"}, "--velocity");
    check_options_refused({"sphere", "--motion", "rotate", "--array", "wind"}, "--array");
    check_options_refused({"sphere", "--motion", "shear", "--speed", "2"}, "--speed");
    check_options_refused({"sphere", "--motion", "curl-noise", "--frequency", "0.5"}, "--frequency");
    check_options_refused({"sphere", "--motion", "curl-noise", "--gradient", "0,1,0"}, "--gradient");
}

TEST_CASE("passes are switched off by name") {
    const Options options = *parsed({"sphere", "--without", "smoothing,interface-flips"});
    dsc3d::DeformParameters parameters{.edge_length = 1};
    switch_off(options.without, parameters);
    CHECK_FALSE(parameters.smooths);
    CHECK_FALSE(parameters.flips_interface);
    CHECK(parameters.flips);
    for (const std::string& name : pass_names()) {
        dsc3d::DeformParameters changed{.edge_length = 1};
        switch_off(name, changed);
        CHECK_NOTHROW(changed.validate());
    }
    check_options_refused({"sphere", "--without", "smoothing,flop"}, "flop");
    check_options_refused({"disc", "--dimension", "2", "--without", "smoothing"}, "--without");
}

TEST_CASE("options that are wrong, missing or of no use are refused by name") {
    check_options_refused({"ball"}, "ball");
    check_options_refused({"sphere", "--center", "1,2"}, "--center");
    check_options_refused({"sphere", "--center", "1,2,x"}, "--center");
    check_options_refused({"sphere", "--domain", "0,0,0,1,1,0"}, "--domain");
    check_options_refused({"sphere", "--radius", "0"}, "--radius");
    check_options_refused({"sphere", "--edge-length", "-1"}, "--edge-length");
    check_options_refused({"box", "--size", "1,2"}, "--size");
    check_options_refused({"box", "--size", "1,2,-3"}, "--size");
    check_options_refused({"slotted-cube", "--size", "1,1,2"}, "--size");
    check_options_refused({"sphere", "--gap", "0.1"}, "--gap");
    check_options_refused({"ball.off", "--radius", "0.1"}, "--radius");
    check_options_refused({"ball.off", "--feature-angle", "60"}, "--feature-angle");
    check_options_refused({"sphere", "--motion", "spin"}, "--motion");
    check_options_refused({"sphere", "--motion", "curvature", "--axis", "1,0,0"}, "--axis");
    check_options_refused({"sphere", "--axis", "0,0,0"}, "--axis");
    check_options_refused({"sphere", "--motion", "offset"}, "--distance");
    check_options_refused({"sphere", "--motion", "translate"}, "--velocity");
    check_options_refused({"sphere", "--motion", "translate", "--velocity", "x=1"}, "--velocity");
    check_options_refused({"sphere", "--motion", "expression"}, "--velocity");
    check_options_refused({"sphere", "--dt", "0.1", "--until", "1", "--steps", "10"}, "--steps");
    check_options_refused({"sphere", "--dt", "nan"}, "--dt");
    check_options_refused({"sphere", "--dimension", "4"}, "--dimension");
    check_options_refused({"sphere", "--topology", "none"}, "--topology");
    const std::vector<const char*> without_folder = {"flow", "sphere"};
    CHECK_THROWS_WITH(parse_options(2, without_folder.data()), Catch::Contains("-o"));
}
