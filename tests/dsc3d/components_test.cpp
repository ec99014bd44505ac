// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/components.h"

#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/dsc3d/volumes.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

TEST_CASE("random labels have as many components as a walk through faces finds, and each has one label") {
    core::Random random(seed(1));
    for (int count = 1; count <= 4; ++count) {
        TetData data = box({4, 3, 3});
        label_randomly(data, count, random);
        const Mesh mesh(data);
        const Complex& complex = mesh.complex();
        core::DisjointSets parts = components(complex);
        std::map<int, std::set<std::uint32_t>> by_label;
        for (const TetId t : tets(complex)) {
            const std::uint32_t first = parts.find(t.index());
            REQUIRE(complex.label(TetId(first)) == complex.label(t));
            by_label[complex.label(t)].insert(first);
            for (int i = 0; i < 4; ++i) {
                const TetId next = complex.neighbour(t, i);
                if (next.is_valid() && complex.label(next) == complex.label(t))
                    REQUIRE(parts.find(next.index()) == first);
            }
        }
        for (const auto& [label, found] : by_label)
            CHECK(static_cast<int>(found.size()) == components_of_label(complex, label));
    }
}

TEST_CASE("tetrahedra that share an edge only are apart, and deleted ones are alone") {
    Mesh mesh(fan(6));
    Complex& complex = mesh.complex();
    complex.set_label(TetId(0), 1);
    complex.set_label(TetId(2), 1);
    core::DisjointSets parts = components(complex);
    CHECK(parts.find(0) != parts.find(2));
    CHECK(parts.find(3) == parts.find(5));
    CHECK(parts.find(1) != parts.find(3));  // of one label, but with 0 and 2 between them

    // The tetrahedron at the end of a pile of two.
    TetData pile;
    pile.vertices = {Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(0, 0, 1), Point3(0, 0, -1)};
    pile.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
    Mesh two(pile);
    CHECK(components(two.complex()).find(0) == components(two.complex()).find(1));
    const std::array<TetId, 1> last = {TetId(1)};
    two.complex().replace(last, {});
    core::DisjointSets left = components(two.complex());
    CHECK(left.find(0) == 0);
    CHECK(left.find(1) == 1);
}
