// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/flat_surface.h"

#include <cmath>

#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;

namespace {

struct Census {
    std::map<VertexMotion, int> vertices;
    std::set<std::int32_t> patches, lines;
    int ridge_edges = 0;

    Census(const Mesh& mesh, const FlatSurface& surface) {
        const Complex& complex = mesh.complex();
        EdgeRing ring;
        for (const VertexId v : dsc::tests::vertices(complex)) {
            ++vertices[surface.motion(v)];
            if (surface.motion(v) == VertexMotion::line) lines.insert(surface.freedom(v).carrier);
        }
        for (const FaceId f : faces(complex)) {
            if (complex.is_surface(f))
                patches.insert(surface.patch(f));
            else
                CHECK(surface.patch(f) == FlatSurface::no_patch);
        }
        for (const EdgeId e : edges(complex))
            if (complex.is_surface(e) && surface.is_ridge(complex, e, ring)) ++ridge_edges;
    }
    int count(VertexMotion motion) const {
        const auto found = vertices.find(motion);
        return found == vertices.end() ? 0 : found->second;
    }
};

double diagonal(const Cells& cells) {
    return std::sqrt(double(cells[0]) * cells[0] + cells[1] * cells[1] + cells[2] * cells[2]);
}

}  // namespace

TEST_CASE("a box has six patches, twelve straight ridges and eight fixed corners, however it lies") {
    for (const bool is_oblique : {false, true}) {
        TetData data = box({4, 3, 3});
        if (is_oblique) turn(data);
        const Mesh mesh(data);
        const FlatSurface surface(mesh, {});
        const Census census(mesh, surface);
        CHECK(census.patches.size() == 6);
        CHECK(census.lines.size() == 12);
        CHECK(census.ridge_edges == 4 * (4 + 3 + 3));
        CHECK(census.count(VertexMotion::fixed) == 8);
        CHECK(census.count(VertexMotion::line) == 4 * (3 + 2 + 2));
        CHECK(census.count(VertexMotion::plane) == 2 * (3 * 2 + 3 * 2 + 2 * 2));
        CHECK(census.count(VertexMotion::free) == 3 * 2 * 2);
    }
}

TEST_CASE("an interface is a patch of its own, and cuts the patches and ridges it meets") {
    TetData data = box({4, 3, 3});
    label_slabs(data, {4, 3, 3}, 2);
    turn(data);
    const Mesh mesh(data);
    const Census census(mesh, FlatSurface(mesh, {}));
    CHECK(census.patches.size() == 2 * 5 + 1);
    CHECK(census.lines.size() == 8 + 2 * 4 + 4);  // of the end faces; the other four, each in two; of the interface
    CHECK(census.ridge_edges == 4 * (4 + 3 + 3) + 4 * 3);
    CHECK(census.count(VertexMotion::fixed) == 8 + 4);
    CHECK(census.count(VertexMotion::line) == 8 * 2 + 4 * 2 * 1 + 4 * 2);
    CHECK(census.count(VertexMotion::plane) == 2 * 2 * 2 + 2 * 4 * 2 * 1 + 2 * 2);
    CHECK(census.count(VertexMotion::free) == 2 * 1 * 2 * 2);
}

TEST_CASE("a patch lies on one interface only") {
    // Two slabs that swap their labels half way up: the interface between them has one plane and two patches.
    TetData data = box({2, 2, 2});
    for (const auto& tet : data.tets) {
        Point3 middle = Point3::Zero();
        for (const std::uint32_t v : tet) middle += data.vertices[v] / 4;
        data.labels.push_back((middle.x() < 1) == (middle.z() < 1) ? 1 : 2);
    }
    const Mesh mesh(data);
    const FlatSurface surface(mesh, {});
    std::map<bool, std::set<std::int32_t>> patches;  // of the plane x = 1, by whether above z = 1
    for (const FaceId f : faces(mesh.complex())) {
        const FaceVertices v = mesh.complex().vertices(f);
        if (!std::all_of(v.begin(), v.end(), [&](VertexId u) { return mesh.position(u).x() == 1; })) continue;
        double z = 0;
        for (const VertexId u : v) z += mesh.position(u).z() / 3;
        patches[z > 1].insert(surface.patch(f));
    }
    REQUIRE(patches.size() == 2);
    for (const auto& [is_above, found] : patches) CHECK(found.size() == 1);
    CHECK(patches[false] != patches[true]);
}

TEST_CASE("a surface that is bent by more than the tolerance is fixed, by less it is flat") {
    const Cells cells = {3, 3, 3};
    for (const double tolerance : {1e-9, 1e-5}) {
        Random random(seed(1));
        TetData rough = box(cells), smooth = box(cells);
        shake_all(rough, 1e4 * tolerance, random);
        shake_all(smooth, 0.05 * tolerance * diagonal(cells), random);
        const Mesh rough_mesh(rough), smooth_mesh(smooth);
        const FlatSurfaceParameters parameters = {.tolerance = tolerance};
        const Census of_rough(rough_mesh, FlatSurface(rough_mesh, parameters));
        CHECK(of_rough.count(VertexMotion::fixed) == 64 - 8);
        const Census of_smooth(smooth_mesh, FlatSurface(smooth_mesh, parameters));
        CHECK(of_smooth.count(VertexMotion::fixed) == 8);
        CHECK(of_smooth.count(VertexMotion::line) == 24);
        CHECK(of_smooth.count(VertexMotion::plane) == 24);
        CHECK(of_smooth.patches.size() == 6);
    }
}

TEST_CASE("the surface of a round solid is fixed") {
    const Mesh mesh(ball(2));
    const Census census(mesh, FlatSurface(mesh, {}));
    CHECK(census.count(VertexMotion::fixed) == static_cast<int>(mesh.complex().vertex_count()) - 1);
    CHECK(census.count(VertexMotion::free) == 1);
    CHECK(census.patches.size() == 20 * 16);
}

TEST_CASE("a surface that may not change is fixed, flat or not") {
    const Mesh mesh(box({2, 2, 2}));
    const Census census(mesh, FlatSurface(mesh, {.may_change = false}));
    CHECK(census.count(VertexMotion::fixed) == 26);
    CHECK(census.count(VertexMotion::free) == 1);
    CHECK(census.patches.size() == 6 * 4 * 2);
}

TEST_CASE("faces are bent at a ridge when their angle or their distance says so") {
    // The edge in the middle of the upper side is lifted by h: a roof bent by 2 atan(h).
    for (const double h : {0.05, 0.2, 0.4}) {
        TetData data = box({2, 1, 1});
        for (Point3& p : data.vertices)
            if (p.x() == 1 && p.z() == 1) p.z() += h;
        const Mesh mesh(data);
        const double bend = 2 * std::atan(h) * 180 / std::numbers::pi;
        const auto is_one_patch = [&](const FlatSurfaceParameters& parameters) {
            const FlatSurface surface(mesh, parameters);
            std::set<std::int32_t> patches;
            for (const FaceId f : faces(mesh.complex())) {
                const FaceVertices v = mesh.complex().vertices(f);
                if (mesh.complex().is_boundary(f) &&
                    std::all_of(v.begin(), v.end(), [&](VertexId u) { return mesh.position(u).z() >= 1; }))
                    patches.insert(surface.patch(f));
            }
            return patches.size() == 1;
        };
        CHECK(is_one_patch({.tolerance = 1, .feature_angle = bend + 1}));
        CHECK_FALSE(is_one_patch({.tolerance = 1, .feature_angle = bend - 1}));
        CHECK_FALSE(is_one_patch({.tolerance = 0.1 * h, .feature_angle = bend + 1}));
    }
}

TEST_CASE("a vertex that slides a thousand times is still on its plane, or on its ridge") {
    TetData data = box({3, 3, 3});
    turn(data);
    Mesh mesh(data);
    const FlatSurface surface(mesh, {});
    Random random(seed(2));
    const auto motion = oblique_motion();
    for (const VertexId v : vertices(mesh.complex())) {
        const VertexMotion kind = surface.motion(v);
        const Point3 begin = mesh.position(v);
        Point3 p = begin;
        for (int slide = 0; slide < 1000; ++slide) {
            const Eigen::Vector3d wish(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
            const Eigen::Vector3d step = surface.allowed(v, wish);
            // The projection of the wish: what was taken away is across what is left.
            REQUIRE(std::abs(step.dot(wish - step)) < 1e-15);
            const Point3 next = surface.settled(v, p + step);
            REQUIRE((next - (p + step)).norm() < 1e-14);
            if ((next - begin).norm() < 1) p = next;
        }
        const Eigen::Vector3d moved = motion.linear().transpose() * (p - begin);
        const Point3 at = motion.inverse() * begin;
        int free_axes = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_at_side = std::abs(at[axis]) < 1e-9 || std::abs(at[axis] - 3) < 1e-9;
            free_axes += is_at_side ? 0 : 1;
            if (is_at_side) CHECK(std::abs(moved[axis]) < 4e-15);
        }
        CHECK(kind == (free_axes == 3   ? VertexMotion::free
                       : free_axes == 2 ? VertexMotion::plane
                       : free_axes == 1 ? VertexMotion::line
                                        : VertexMotion::fixed));
        CHECK((kind == VertexMotion::fixed) == (moved.norm() == 0));
    }
}

TEST_CASE("on a flat boundary, interfaces are fixed and have no patches, and labels don't part the patches") {
    TetData data = box({4, 3, 3});
    label_slabs(data, {4, 3, 3}, 2);
    turn(data);
    Mesh mesh(data);
    Complex& complex = mesh.complex();
    const FlatSurface surface = FlatSurface::flat_boundary(mesh);
    std::set<std::int32_t> patches;
    for (const FaceId f : faces(complex)) {
        CHECK(surface.has_patch(complex, f) == complex.is_boundary(f));
        if (complex.is_boundary(f)) patches.insert(surface.patch(f));
    }
    CHECK(patches.size() == 6);
    const auto require_motions = [&] {
        for (const VertexId v : vertices(complex)) {
            const Point3 at = oblique_motion().inverse() * mesh.position(v);
            int free_axes = 0;
            for (int axis = 0; axis < 3; ++axis)
                free_axes += std::abs(at[axis]) > 1e-9 && std::abs(at[axis] - (axis == 0 ? 4 : 3)) > 1e-9 ? 1 : 0;
            const VertexMotion of_box = free_axes == 3   ? VertexMotion::free
                                        : free_axes == 2 ? VertexMotion::plane
                                        : free_axes == 1 ? VertexMotion::line
                                                         : VertexMotion::fixed;
            REQUIRE(surface.motion(v) == (complex.is_interface(v) ? VertexMotion::fixed : of_box));
        }
    };
    require_motions();
    // Labels change; what was on the interface moves as its place on the boundary lets it.
    for (const TetId t : tets(complex)) complex.set_label(t, t.index() % 5 == 0 ? 1 : 0);
    require_motions();
    for (const TetId t : tets(complex)) complex.set_label(t, 0);
    require_motions();
}
