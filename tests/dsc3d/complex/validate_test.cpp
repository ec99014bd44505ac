// SPDX-License-Identifier: GPL-3.0-or-later
// What validate() has to find is made by replacing tetrahedra against the precondition of replace.
#include "dsc3d/complex/validate.h"

#include "dsc3d/mesh.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

std::string all_of(const std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& problem : problems) text += problem + "\n";
    return text;
}

bool finds(const Complex& complex, const std::string& problem) {
    const std::string found = all_of(validate(complex));
    INFO(found);
    return found.find(problem) != std::string::npos;
}

}  // namespace

TEST_CASE("validate is content with good complexes") {
    dsc::core::Random random(seed(1));
    TetData labelled = box({3, 2, 2});
    label_randomly(labelled, 4, random);
    for (const TetData& data : {box({1, 1, 1}), labelled, ball(1), fan(7, 1, random)}) {
        const Mesh mesh(data);
        CHECK(all_of(validate(mesh)) == "");
        CHECK(all_of(validate(mesh.complex())) == "");
    }
}

TEST_CASE("validate finds two tetrahedra on one side of a face") {
    Mesh mesh(fan(5));
    Complex& complex = mesh.complex();
    NewTet turned = {complex.vertices(TetId(0))};
    std::swap(turned.vertices[0], turned.vertices[1]);
    const std::array removed = {TetId(0)};
    complex.replace(removed, std::array{turned});
    CHECK(finds(complex, "has both tetrahedra on one side"));
}

TEST_CASE("validate finds an edge whose star falls apart") {
    Mesh mesh(fan(6));
    const std::array removed = {TetId(0), TetId(3)};
    mesh.complex().replace(removed, {});
    CHECK(finds(mesh.complex(), "[0 1]: its star falls apart"));
    CHECK(finds(mesh.complex(), "[0 1] has 4 boundary faces"));
}

TEST_CASE("validate finds a vertex whose star falls apart") {
    // What is left of a cube's corner-to-corner ring: two tetrahedra that share one vertex only.
    Mesh mesh(box({2, 1, 1}));
    Complex& complex = mesh.complex();
    bool is_found = false;
    for (const TetId s : tets(complex)) {
        for (const TetId t : tets(complex)) {
            std::vector<VertexId> shared;
            for (const VertexId v : complex.vertices(s))
                if (complex.has_vertex(t, v)) shared.push_back(v);
            if (shared.size() != 1 || is_found) continue;
            is_found = true;
            std::vector<TetId> removed;
            for (const TetId other : tets(complex))
                if (other != s && other != t) removed.push_back(other);
            complex.replace(removed, {});
            CHECK(complex.tet_count() == 2);
            CHECK(finds(complex, "vertex " + std::to_string(shared[0].index()) + ": its star falls apart"));
        }
    }
    CHECK(is_found);
}

TEST_CASE("validate finds a vertex whose link is an annulus") {
    // Of the ball around a centre, two tetrahedra that do not touch but in the centre go: the link is a sphere with
    // two holes.
    Mesh mesh(ball(1));
    Complex& complex = mesh.complex();
    TetId far;
    for (const TetId t : tets(complex)) {
        int shared = 0;
        for (const VertexId v : complex.vertices(t)) shared += complex.has_vertex(TetId(0), v) ? 1 : 0;
        if (shared == 1) far = t;
    }
    const std::array removed = {TetId(0), far};
    complex.replace(removed, {});
    CHECK(finds(complex, ": its link is neither a sphere nor a disc"));
}

TEST_CASE("validate finds tetrahedra that are flat or inverted, and says no more than it is asked for") {
    Mesh mesh(ball(0));
    const VertexId centre(12);
    mesh.set_position(centre, Point3(5, 0, 0));
    CHECK(validate(mesh.complex()).empty());
    const std::vector<std::string> problems = validate(mesh);
    CHECK(problems.size() > 3);
    CHECK(all_of(problems).find("is not positive") != std::string::npos);
    CHECK(validate(mesh, 3).size() == 3);

    const TetVertices& v = mesh.complex().vertices(TetId(0));
    Point3 in_face = Point3::Zero();
    for (const VertexId u : v)
        if (u != centre) in_face = mesh.position(u);
    mesh.set_position(centre, in_face);
    CHECK(validate(mesh).front() == "tetrahedron 0 is not positive");
}
