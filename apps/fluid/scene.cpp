// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <set>

#include "core/assert.h"
#include "core/errors.h"

namespace dsc::fluid_app {

namespace {

constexpr double cells_per_cubic_edge = 6;
constexpr double largest_number = 1e40;
constexpr double most_cells = 2e7;  // some 20 GB with the matrices

Scene droplet() {
    Scene scene{.name = "droplet"};
    scene.balls = {{.swell = 0.05}};
    scene.until = 4;
    return scene;
}

// Figure 6.5.
Scene collide() {
    Scene scene{.name = "collide", .domain = {Point3(-4, -2.5, -2.5), Point3(4, 2.5, 2.5)}, .edge_length = 0.22};
    scene.balls = {{.centre = Point3(-1.3, 0, 0), .velocity = Point3(1, 0, 0)},
                   {.centre = Point3(1.3, 0, 0), .velocity = Point3(-1, 0, 0)}};
    scene.until = 6;
    return scene;
}

// Figure 6.6.
Scene oblique() {
    Scene scene{.name = "oblique", .domain = {Point3(-8, -5, -2.5), Point3(8, 5, 2.5)}, .edge_length = 0.22};
    scene.balls = {{.centre = Point3(-1.6, -0.6, 0), .velocity = Point3(3, 0, 0)},
                   {.centre = Point3(1.6, 0.6, 0), .velocity = Point3(-3, 0, 0)}};
    scene.until = 4;
    return scene;
}

Scene freefall() {
    Scene scene{.name = "freefall", .domain = {Point3(-2, -2, -8), Point3(2, 2, 2)}, .edge_length = 0.25};
    scene.balls = {{}};
    scene.gravity = Point3(0, 0, -9.81);
    scene.until = 1;
    return scene;
}

Scene tank() {
    Scene scene{.name = "tank", .domain = {Point3(0, 0, 0), Point3(1, 1, 1)}, .edge_length = 0.125};
    scene.depth = 0.5;
    scene.tension = 0;
    scene.gravity = Point3(0, 0, -9.81);
    scene.until = 1;
    return scene;
}

// A column of water is let go in a tank.
Scene dam() {
    Scene scene{.name = "dam", .domain = {Point3(0, 0, 0), Point3(4, 1, 2)}, .edge_length = 0.125};
    scene.column = Point3(1, 1, 1);
    scene.tension = 0.01;
    scene.viscosity = 0.002;
    scene.gravity = Point3(0, 0, -9.81);
    scene.until = 1;
    return scene;
}

// Figure 6.7.
Scene sessile() {
    Scene scene{.name = "sessile", .domain = {Point3(-2, -2, 0), Point3(2, 2, 2)}, .edge_length = 0.2};
    scene.sessile_radius = 1;
    scene.wetting = -0.3;
    scene.viscosity = 0.2;
    scene.until = 8;
    return scene;
}

// Figure 6.8.
Scene vessel() {
    Scene scene{.name = "vessel", .edge_length = 0.2};
    scene.vessel = {.radius = 2};
    scene.balls = {{.centre = Point3(-1, 0, 0), .radius = 0.7, .velocity = Point3(1, 0, 0)},
                   {.centre = Point3(1, 0, 0.3), .radius = 0.7, .velocity = Point3(-1, 0, 0)}};
    scene.gravity = Point3(0, 0, -3);
    scene.viscosity = 0.02;
    scene.until = 3;
    return scene;
}

struct Named {
    const char* name;
    Scene (*make)();
};
constexpr Named scenes[] = {{"droplet", droplet}, {"collide", collide}, {"oblique", oblique}, {"freefall", freefall},
                            {"tank", tank},       {"dam", dam},         {"sessile", sessile}, {"vessel", vessel}};

// Members of an object, each known by its path.
class Reader {
public:
    Reader(const io::Json& json, std::string source, std::string path)
        : json_(json), source_(std::move(source)), path_(std::move(path)) {
        if (!json.is_object()) fail("", "is not an object", "write { … }");
    }

    void number(const std::string& key, double& value, const std::function<bool(double)>& is_valid,
                const std::string& range) {
        known_.insert(key);
        if (!json_.has(key)) return;
        if (!json_[key].is_number()) fail(key, "is not a number", "give " + range);
        value = json_[key].number();
        if (!std::isfinite(value) || !is_valid(value)) fail(key, "is out of range", "give " + range);
    }
    void point(const std::string& key, Point3& value) {
        known_.insert(key);
        if (json_.has(key)) value = parsed_point(json_[key], key);
    }
    void box(const std::string& key, Eigen::AlignedBox3d& value) {
        known_.insert(key);
        if (!json_.has(key)) return;
        if (!json_[key].is_array() || json_[key].size() != 2)
            fail(key, "is not a box", "give [[x0, y0, z0], [x1, y1, z1]]");
        value = {parsed_point(json_[key][0], key + "[0]"), parsed_point(json_[key][1], key + "[1]")};
        if (!(value.sizes().minCoeff() > 0)) fail(key, "is empty", "give the lower corner first");
    }
    const io::Json* object(const std::string& key) {
        known_.insert(key);
        return json_.has(key) ? &json_[key] : nullptr;
    }
    const io::Json* list(const std::string& key) {
        known_.insert(key);
        if (!json_.has(key)) return nullptr;
        if (!json_[key].is_array()) fail(key, "is not a list", "write [ … ]");
        return &json_[key];
    }
    void text(const std::string& key, std::string& value, const std::set<std::string>& choices) {
        known_.insert(key);
        if (!json_.has(key)) return;
        if (!json_[key].is_string() || !choices.contains(json_[key].string()))
            fail(key, "is none of the words that can stand here", "give \"" + *choices.begin() + "\"");
        value = json_[key].string();
    }
    void text(const std::string& key, std::string& value) {
        known_.insert(key);
        if (!json_.has(key)) return;
        if (!json_[key].is_string()) fail(key, "is not text", "write it in quotes");
        value = json_[key].string();
    }
    void require_known() const {
        for (const auto& [key, value] : json_.members())
            if (!known_.contains(key)) fail(key, "is not known", "check its spelling");
    }

private:
    Point3 parsed_point(const io::Json& value, const std::string& key) const {
        bool is_point = value.is_array() && value.size() == 3;
        for (std::size_t k = 0; is_point && k < 3; ++k)
            is_point = value[k].is_number() && std::isfinite(value[k].number());
        if (!is_point) fail(key, "is not three numbers", "give [x, y, z]");
        return {value[0].number(), value[1].number(), value[2].number()};
    }
    [[noreturn]] void fail(const std::string& key, const std::string& problem, const std::string& cure) const {
        throw core::InputError(source_, key.empty() ? path_ : path_ + (path_.empty() ? "" : ".") + key, problem, cure);
    }

    const io::Json& json_;
    std::string source_, path_;
    std::set<std::string> known_;
};

int kinds_of_fluid(const Scene& scene) {
    return (scene.balls.empty() ? 0 : 1) + (scene.depth ? 1 : 0) + (scene.column ? 1 : 0) +
           (scene.sessile_radius ? 1 : 0);
}

Ball ball_from_json(const io::Json& json, const std::string& source, const std::string& path) {
    Reader reader(json, source, path);
    Ball ball;
    std::string shape = "sphere";
    reader.text("shape", shape, {"sphere", "surface"});
    std::string file;
    reader.text("file", file);
    reader.point("centre", ball.centre);
    reader.number(
        "radius", ball.radius, [](double r) { return r > 0; }, "a positive number");
    reader.point("velocity", ball.velocity);
    reader.point("spin", ball.spin);
    reader.number(
        "swell", ball.swell, [](double s) { return std::abs(s) < 0.5; }, "a number in (-0.5, 0.5)");
    reader.require_known();
    if ((shape == "surface") == file.empty())
        throw core::InputError(source, path, shape == "surface" ? "has no file" : "has a file, but is a sphere",
                               "shape \"surface\" and \"file\" go together");
    if (ball.swell != 0 && shape == "surface")
        throw core::InputError(source, path + ".swell", "is of spheres only", "leave it out");
    if (!file.empty()) ball.surface = (std::filesystem::path(source).parent_path() / file).string();
    return ball;
}

}  // namespace

namespace {

/// Edges of a scene of uniform cells, and of the fluid in one that is graded, fill this volume.
double finely_meshed_volume(const Scene& scene) {
    if (scene.balls.empty()) return scene.domain.volume();
    double volume = 0;
    for (const Ball& ball : scene.balls) volume += 4 * EIGEN_PI / 3 * std::pow(ball.radius, 3);
    return volume;
}

// Their products have to be numbers still.
void require_magnitudes(const Scene& scene, const std::string& source) {
    double largest =
        std::max({scene.density, scene.tension, scene.viscosity, scene.until, scene.gravity.cwiseAbs().maxCoeff(),
                  scene.domain.min().cwiseAbs().maxCoeff(), scene.domain.max().cwiseAbs().maxCoeff()});
    for (const Ball& ball : scene.balls)
        largest = std::max({largest, ball.velocity.cwiseAbs().maxCoeff(), ball.spin.cwiseAbs().maxCoeff()});
    if (largest > largest_number)
        throw core::InputError(source, "", fmt::format("has {:g}, which is too large to compute with", largest),
                               "choose other units");
}

void require_size(const Scene& scene, const std::string& source) {
    const double cells = cells_per_cubic_edge * finely_meshed_volume(scene) / std::pow(scene.edge_length, 3);
    if (!(cells <= most_cells))
        throw core::InputError(source, "edge_length", fmt::format("would take about {:.2g} tetrahedra", cells),
                               "make it larger, or the scene smaller");
}

}  // namespace

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const Named& scene : scenes) names.emplace_back(scene.name);
    return names;
}

Scene named_scene(const std::string& name) {
    for (const Named& scene : scenes)
        if (scene.name == name) return scene.make();
    DSC_ASSERT(false);
    return {};
}

Scene scene_from_json(const io::Json& json, const std::string& source) {
    Reader reader(json, source, "");
    Scene scene{.name = source};
    const auto positive = [](double x) { return x > 0; };
    const auto not_negative = [](double x) { return x >= 0; };
    reader.box("domain", scene.domain);
    reader.number("edge_length", scene.edge_length, positive, "a positive number");
    reader.number("density", scene.density, positive, "a positive number");
    reader.number("tension", scene.tension, not_negative, "a number that is not negative");
    reader.number("viscosity", scene.viscosity, not_negative, "a number that is not negative");
    reader.number(
        "wetting", scene.wetting, [](double x) { return std::abs(x) <= 1; }, "a number in [-1, 1]");
    reader.number("until", scene.until, positive, "a positive number");
    reader.point("gravity", scene.gravity);
    double depth = 0;
    reader.number("depth", depth, positive, "a positive number");
    if (depth > 0) scene.depth = depth;
    if (json.has("column")) {
        scene.column.emplace();
        reader.point("column", *scene.column);
    }
    double radius = 0;
    reader.number("sessile_radius", radius, positive, "a positive number");
    if (radius > 0) scene.sessile_radius = radius;
    if (const io::Json* given = reader.object("vessel")) {
        scene.vessel.emplace();
        Reader members(*given, source, "vessel");
        members.point("centre", scene.vessel->centre);
        members.number("radius", scene.vessel->radius, positive, "a positive number");
        members.require_known();
        if (json.has("domain")) throw core::InputError(source, "domain", "does not go with a vessel", "leave it out");
        const Point3 reach = Point3::Constant(scene.vessel->radius);
        scene.domain = {scene.vessel->centre - reach, scene.vessel->centre + reach};
    }
    if (const io::Json* bodies = reader.list("bodies"))
        for (std::size_t i = 0; i < bodies->size(); ++i)
            scene.balls.push_back(ball_from_json((*bodies)[i], source, "bodies[" + std::to_string(i) + "]"));
    reader.require_known();
    if (kinds_of_fluid(scene) == 0)
        throw core::InputError(source, "bodies", "there is no fluid",
                               "give a body, the depth of a tank, a column, or the radius of a sessile drop");
    return scene;
}

void require_consistent(const Scene& scene, const std::string& source) {
    const auto fail = [&](const std::string& where, const std::string& problem, const std::string& cure) {
        throw core::InputError(source, where, problem, cure);
    };
    if (kinds_of_fluid(scene) > 1)
        fail("", "bodies, the depth of a tank, a column and a sessile drop don't go together yet", "keep one of them");
    require_magnitudes(scene, source);
    require_size(scene, source);
    if (scene.sessile_radius &&
        1.5 * *scene.sessile_radius > std::min(scene.domain.sizes().head<2>().minCoeff() / 2, scene.domain.sizes().z()))
        fail("sessile_radius", "the domain is not half as large again as the drop", "make the domain larger");
    if (scene.column &&
        !((scene.column->array() > 0).all() && (scene.column->array() <= scene.domain.sizes().array()).all()))
        fail("column", "is not inside of the domain", "give its size, [width, depth, height]");
    if (scene.depth && *scene.depth >= scene.domain.sizes().z())
        fail("depth", "the tank is not that high", "make the domain higher");
    if (scene.vessel && scene.balls.empty()) fail("vessel", "there are no bodies in it", "give bodies");
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const Ball& ball = scene.balls[i];
        const Point3 reach = Point3::Constant(1.5 * ball.radius);
        const std::string where = fmt::format("bodies[{}]", i);
        if (!scene.vessel && !scene.domain.contains(Eigen::AlignedBox3d(ball.centre - reach, ball.centre + reach)))
            fail(where, "is not inside of the domain, with half of its radius around it", "make the domain larger");
        if (scene.vessel && (ball.centre - scene.vessel->centre).norm() + 1.02 * ball.radius > scene.vessel->radius)
            fail(where, "is not inside of the vessel", "move it, or make the vessel larger");
        for (std::size_t k = 0; k < i; ++k)
            if ((ball.centre - scene.balls[k].centre).norm() <= 1.05 * (ball.radius + scene.balls[k].radius))
                fail(where, fmt::format("meets bodies[{}]", k), "move them apart");
    }
}

}  // namespace dsc::fluid_app
