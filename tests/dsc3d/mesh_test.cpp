// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/mesh.h"

#include <limits>

#include "core/errors.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

std::string complaint(const TetData& data) {
    try {
        const Mesh mesh(data, "sample.mesh");
    } catch (const dsc::core::InputError& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a mesh gives back the vertices, tetrahedra and labels it was made from") {
    dsc::core::Random random(seed(1));
    TetData data = box({3, 2, 2});
    shake_inside(data, 0.3, random);
    CHECK(Mesh(data).data().labels.empty());
    label_randomly(data, 3, random);
    const TetData back = Mesh(data).data();
    CHECK(back.vertices == data.vertices);
    CHECK(back.tets == data.tets);
    CHECK(back.labels == data.labels);
}

TEST_CASE("vertices that no tetrahedron uses are dropped, the others keep their order") {
    TetData data = box({1, 1, 1});
    const TetData expected = data;
    data.vertices.insert(data.vertices.begin() + 3, Point3(9, 9, 9));
    data.vertices.push_back(Point3(8, 8, 8));
    for (auto& tet : data.tets)
        for (std::uint32_t& v : tet) v += v >= 3 ? 1 : 0;
    const TetData back = Mesh(data).data();
    CHECK(back.vertices == expected.vertices);
    CHECK(back.tets == expected.tets);
}

TEST_CASE("the data of a mesh has no gaps where simplices were removed") {
    Mesh mesh(fan(6));
    mesh.complex().replace(std::array{TetId(0), TetId(1)}, {});
    const TetData data = mesh.data();
    CHECK(data.tets.size() == 4);
    CHECK(data.vertices.size() == 7);
    CHECK(labelled_tets(Mesh(data).complex()).size() == 4);
    double before = 0, after = 0;
    for (const auto& [label, sum] : volumes(mesh)) before += sum;
    for (const auto& [label, sum] : volumes(Mesh(data))) after += sum;
    CHECK(before == after);
}

TEST_CASE("a mesh that is mirrored as a whole is turned") {
    TetData data = box({2, 1, 1});
    for (Point3& p : data.vertices) p.x() = -p.x();
    const Mesh mesh(data);
    require_valid(mesh);
    CHECK(volumes(mesh).at(0) == Approx(2));
}

TEST_CASE("input that is no mesh is refused, naming source and element") {
    TetData data = box({2, 2, 2});
    SECTION("nothing") {
        data.tets.clear();
        CHECK(has(complaint(data), "sample.mesh: there are no tetrahedra"));
    }
    SECTION("labels that do not fit") {
        data.labels = {1, 2};
        CHECK(has(complaint(data), "there are not as many labels as tetrahedra"));
    }
    SECTION("an index out of range") {
        data.tets[7][2] = 27;
        CHECK(has(complaint(data), "sample.mesh: tetrahedron 7 (counted from 0): vertex 27 does not exist"));
    }
    SECTION("a vertex twice") {
        data.tets[7][2] = data.tets[7][0];
        CHECK(has(complaint(data), "tetrahedron 7 (counted from 0): a vertex occurs twice"));
    }
    SECTION("coordinates that are not numbers") {
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            data.vertices[11].y() = bad;
            CHECK(has(complaint(data), "vertex 11 (counted from 0): a coordinate is not finite"));
        }
    }
    SECTION("coordinates whose volumes would overflow") {
        data.vertices[11].y() = -1e101;
        CHECK(has(complaint(data), "vertex 11 (counted from 0): a coordinate exceeds 1e100; use a larger unit"));
    }
    SECTION("an inverted tetrahedron") {
        std::swap(data.tets[9][0], data.tets[9][1]);
        CHECK(has(complaint(data), "tetrahedron 9 (counted from 0): it is inverted against the other tetrahedra"));
    }
    SECTION("one that is right among inverted ones") {
        for (auto& tet : data.tets) std::swap(tet[0], tet[1]);
        std::swap(data.tets[9][0], data.tets[9][1]);
        CHECK(has(complaint(data), "tetrahedron 9 (counted from 0): it is inverted against the other tetrahedra"));
    }
    SECTION("a flat tetrahedron") {
        data.tets = {{0, 1, 3, 4}};
        CHECK(has(complaint(data), "tetrahedron 0 (counted from 0): it is flat"));
    }
    SECTION("a face of three tetrahedra") {
        data.vertices.push_back(Point3(-1, -1, 5));
        data.vertices.push_back(Point3(-1, -1, 6));
        data.tets = {{0, 1, 3, 9}, {0, 1, 3, 27}, {0, 1, 3, 28}};
        CHECK(has(complaint(data), "sample.mesh: tetrahedron 1"));
    }
}

TEST_CASE("exact positivity decides where rounded arithmetic cannot") {
    // The fourth vertex lies one unit in the last place above, in and below the plane through the others.
    const double z = 1.0 / 3;
    for (const int side : {-1, 0, 1}) {
        TetData data;
        const double height = side == 0 ? z : std::nextafter(z, side > 0 ? 1.0 : 0.0);
        data.vertices = {Point3(0.1, 0.2, z), Point3(12.3, 0.4, z), Point3(0.5, 45.6, z), Point3(3.3, 4.4, height)};
        data.tets = {{0, 1, 2, 3}};
        CHECK(has(complaint(data), "it is flat") == (side == 0));
        if (side == 0) continue;
        const Mesh mesh(data);
        require_valid(mesh);
        CHECK(mesh.complex().vertices(TetId(0))[2] == VertexId(side > 0 ? 2 : 3));
    }
}
