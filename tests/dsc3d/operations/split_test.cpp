// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/split.h"

#include "tests/dsc3d/random_topology.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;

namespace {

template <class Vertices>
Point3 random_place(const Mesh& mesh, const Vertices& corners, Random& random) {
    Point3 sum = Point3::Zero();
    double weights = 0;
    for (const VertexId v : corners) {
        const double weight = random.uniform(0.2, 1);
        weights += weight;
        sum += weight * mesh.position(v);
    }
    return sum / weights;
}

// Splits the simplex, checks what the header promises, and undoes it by a collapse of an edge at the new vertex.
template <class Simplex>
void check_split_and_collapse(Mesh& mesh, Simplex simplex, Random& random, StarWalker& walker) {
    Complex& complex = mesh.complex();
    const auto corners = complex.vertices(simplex);
    const Point3 place = random_place(mesh, corners, random);
    if (!can_split(mesh, simplex, place)) return;
    const LabelledTets before = labelled_tets(complex);
    const std::map<int, double> volumes_before = volumes(mesh);
    bool is_on_boundary = false, is_on_interface = false;
    if constexpr (!std::is_same_v<Simplex, TetId>)
        is_on_boundary = complex.is_boundary(simplex), is_on_interface = complex.is_interface(simplex);

    const VertexId m = split(mesh, simplex, place);
    require_valid(mesh);
    REQUIRE(mesh.position(m) == place);
    REQUIRE(complex.is_boundary(m) == is_on_boundary);
    REQUIRE(complex.is_interface(m) == is_on_interface);
    require_same(volumes_before, volumes(mesh), 1e-14);

    EdgeCollapse edge_collapse;
    for (const VertexId kept : corners) {
        const EdgeId e = walker.edge_between(m, kept);
        REQUIRE(e.is_valid());
        REQUIRE(edge_collapse.keeps_topology(complex, e, kept, walker));
    }
    collapse(complex, walker.edge_between(m, corners[0]), corners[0], walker);
    REQUIRE(labelled_tets(complex) == before);
}

Mesh labelled_box(int labels, Random& random) {
    TetData data = box({2, 2, 2});
    label_randomly(data, labels, random);
    shake_inside(data, 0.3, random);
    return Mesh(data);
}

}  // namespace

TEST_CASE("a split divides the tetrahedra at a simplex, and a collapse of the new vertex undoes it") {
    for (const int labels : {1, 3}) {
        Random random(seed(1));
        Mesh mesh = labelled_box(labels, random);
        StarWalker walker(mesh.complex());
        for (const EdgeId e : edges(mesh.complex()))
            if (!mesh.complex().is_deleted(e)) check_split_and_collapse(mesh, e, random, walker);
        for (const FaceId f : faces(mesh.complex()))
            if (!mesh.complex().is_deleted(f)) check_split_and_collapse(mesh, f, random, walker);
        for (const TetId t : tets(mesh.complex()))
            if (!mesh.complex().is_deleted(t)) check_split_and_collapse(mesh, t, random, walker);
    }
}

TEST_CASE("a split makes as many tetrahedra as its simplex has corners for each of those at it") {
    Mesh mesh(box({2, 2, 2}));
    Complex& complex = mesh.complex();
    EdgeRing ring;
    const EdgeId e = edges(complex)[20];
    gather_ring(complex, e, ring);
    std::uint32_t count = complex.tet_count();
    split(complex, e);
    CHECK(complex.tet_count() == count + ring.tets.size());
    for (const bool is_boundary : {false, true}) {
        const std::vector<FaceId> list = faces(complex);
        const FaceId f =
            *std::find_if(list.begin(), list.end(), [&](FaceId g) { return complex.is_boundary(g) == is_boundary; });
        count = complex.tet_count();
        split(complex, f);
        CHECK(complex.tet_count() == count + (is_boundary ? 2 : 4));
    }
    count = complex.tet_count();
    split(complex, tets(complex).front());
    CHECK(complex.tet_count() == count + 3);
    require_valid(complex);
}

TEST_CASE("a place at which a part would be flat or inverted is refused") {
    const Mesh mesh(box({1, 1, 1}));
    const Complex& complex = mesh.complex();
    for (const TetId t : tets(complex)) {
        const TetVertices& v = complex.vertices(t);
        Point3 middle = Point3::Zero();
        for (const VertexId u : v) middle += mesh.position(u) / 4;
        CHECK(can_split(mesh, t, middle));
        CHECK_FALSE(can_split(mesh, t, mesh.position(v[0])));
        CHECK_FALSE(can_split(mesh, t, 0.5 * (mesh.position(v[0]) + mesh.position(v[1]))));  // on an edge: flat
        CHECK_FALSE(can_split(mesh, t, Point3(2, 2, 2)));
        // One ulp beside an axis-parallel face that is too close for rounded arithmetic.
        CHECK_FALSE(can_split(mesh, t, Point3(middle.x(), middle.y(), std::nextafter(1.0, 2.0))));
    }
    for (const EdgeId e : edges(complex)) {
        const EdgeVertices& v = complex.vertices(e);
        CHECK(can_split(mesh, e, 0.5 * (mesh.position(v[0]) + mesh.position(v[1]))));
        CHECK_FALSE(can_split(mesh, e, mesh.position(v[1])));
    }
    for (const FaceId f : faces(complex)) {
        const FaceVertices v = complex.vertices(f);
        const Point3 middle = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
        CHECK(can_split(mesh, f, middle));
        CHECK_FALSE(can_split(mesh, f, 2 * mesh.position(v[1]) - middle));
    }
}
