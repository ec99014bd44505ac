// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/scene.h"

#include <catch2/catch.hpp>

#include "apps/fluid/initial_mesh.h"
#include "core/errors.h"
#include "dsc3d/label_statistics.h"
#include "io/atomic_file.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::fluid_app;

namespace {

Scene parsed(const std::string& text) { return scene_from_json(io::Json::parse(text), "scene.json"); }

void check_refused(const std::string& text, const std::string& place) {
    CAPTURE(text);
    try {
        parsed(text);
        FAIL("not refused");
    } catch (const core::InputError& error) {
        CHECK(error.source() == "scene.json");
        CHECK(error.place() == place);
    }
}

}  // namespace

TEST_CASE("scenes that have a name are consistent", "[fluid]") {
    for (const std::string& name : scene_names()) {
        CAPTURE(name);
        CHECK_NOTHROW(require_consistent(named_scene(name), name));
    }
}

TEST_CASE("a scene is read from JSON", "[fluid]") {
    const Scene scene = parsed(R"({"domain": [[-3, -3, -3], [3, 3, 3]], "edge_length": 0.5, "tension": 2,
        "gravity": [0, 0, -1], "bodies": [{"shape": "sphere", "centre": [0, 1, 0], "velocity": [1, 0, 0]}]})");
    CHECK(scene.domain.max() == Point3(3, 3, 3));
    CHECK(scene.tension == 2);
    CHECK(scene.gravity == Point3(0, 0, -1));
    REQUIRE(scene.balls.size() == 1);
    CHECK(scene.balls[0].centre == Point3(0, 1, 0));
    CHECK(scene.balls[0].radius == 1);
}

TEST_CASE("what is wrong in a scene is named by its path", "[fluid]") {
    check_refused(R"({"bodies": [{}, {"radius": -1}]})", "bodies[1].radius");
    check_refused(R"({"bodies": [{"centre": [0, 0]}]})", "bodies[0].centre");
    check_refused(R"({"bodies": [{"colour": 1}]})", "bodies[0].colour");
    check_refused(R"({"density": 0, "bodies": [{}]})", "density");
    check_refused(R"({"domain": [[0, 0, 0], [1, 1, 0]], "bodies": [{}]})", "domain");
    check_refused(R"({"tension": "much", "bodies": [{}]})", "tension");
    check_refused(R"({"bodies": []})", "bodies");
    check_refused(R"({"domain": [[-1, -1, -1], [1, 1, 1]], "vessel": {}, "bodies": [{"radius": 0.5}]})", "domain");
    check_refused(R"({"bodies": [{"shape": "surface"}]})", "bodies[0]");
    check_refused(R"({"bodies": [{"file": "spot.off"}]})", "bodies[0]");
    check_refused("[]", "");
}

TEST_CASE("bodies that meet or leave the domain are refused", "[fluid]") {
    Scene scene = named_scene("droplet");
    scene.balls.push_back({.centre = Point3(0.1, 0, 0), .radius = 0.5});
    CHECK_THROWS_WITH(require_consistent(scene, "s.json"), Catch::Contains("s.json: bodies[1]: meets bodies[0]"));
    scene.balls = {{.centre = Point3(1.5, 0, 0)}};
    CHECK_THROWS_WITH(require_consistent(scene, "s.json"),
                      Catch::Contains("s.json: bodies[0]") && Catch::Contains("domain"));
    scene.balls = {{}};
    scene.edge_length = 1e-4;
    CHECK_THROWS_WITH(require_consistent(scene, "s.json"), Catch::Contains("edge_length"));
    scene.edge_length = 0.2;
    scene.viscosity = 1e300;
    CHECK_THROWS_WITH(require_consistent(scene, "s.json"), Catch::Contains("units"));
}

TEST_CASE("a tank is filled up to its depth", "[fluid]") {
    core::Observer observer;
    Scene scene = named_scene("tank");
    scene.domain = {Point3(0, 0, 0), Point3(1, 1.5, 1)};
    scene.depth = 0.3;
    const dsc3d::Mesh mesh(initial_mesh(scene, observer).tets);
    const auto labels = dsc3d::label_statistics(mesh);
    REQUIRE(labels.size() == 2);
    CHECK(labels[1].volume == Approx(0.45).epsilon(1e-12));
    CHECK(labels[0].volume == Approx(1.05).epsilon(1e-12));
}

TEST_CASE("a column stands in the corner of its tank", "[fluid]") {
    core::Observer observer;
    Scene scene = named_scene("dam");
    scene.column = Point3(0.7, 1, 0.9);
    const auto labels = dsc3d::label_statistics(dsc3d::Mesh(initial_mesh(scene, observer).tets));
    REQUIRE(labels.size() == 2);
    CHECK(labels[1].volume == Approx(0.63).epsilon(1e-12));
    scene.column->x() = 5;
    CHECK_THROWS_WITH(require_consistent(scene, "s.json"), Catch::Contains("column"));
}

TEST_CASE("a body from a file fits in its ball", "[fluid]") {
    const dsc::tests::TemporaryFolder folder;
    io::write_file(folder / "cube.off",
                   "OFF\n8 12 0\n3 3 3\n5 3 3\n5 5 3\n3 5 3\n3 3 5\n5 3 5\n5 5 5\n3 5 5\n"
                   "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
                   "3 2 3 7\n3 2 7 6\n3 1 2 6\n3 1 6 5\n3 0 4 7\n3 0 7 3\n");
    const std::string path = (folder / "scene.json").string();
    const Scene scene = scene_from_json(
        io::Json::parse(R"({"edge_length": 0.3, "bodies": [{"shape": "surface", "file": "cube.off", "radius": 0.9,
                                                            "centre": [0.1, 0, 0], "velocity": [0, 0, 1]}]})"),
        path);
    core::Observer observer;
    const InitialMesh initial = initial_mesh(scene, observer);
    const auto labels = dsc3d::label_statistics(dsc3d::Mesh(initial.tets));
    REQUIRE(labels.size() == 2);
    CHECK(labels[1].volume == Approx(8 * std::pow(0.9 / std::sqrt(3.0), 3)).epsilon(1e-9));
}
