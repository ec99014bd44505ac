// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/region.h"

#include "dsc3d/operations/split.h"
#include "tests/dsc3d/deform/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;

namespace {

/// The values, which have to be there once each.
template <class Handle>
std::set<Handle> once(const std::vector<Handle>& found) {
    const std::set<Handle> values(found.begin(), found.end());
    REQUIRE(values.size() == found.size());
    return values;
}

}  // namespace

TEST_CASE("a region lists its tetrahedra in the order in which they were added, and their simplices once each") {
    core::Random random(seed(1));
    TetData data = box({4, 4, 4});
    label_randomly(data, 3, random);
    Mesh mesh(data);
    const Complex& complex = mesh.complex();
    RatedMesh rated(mesh, geometry::QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
    Region region;
    std::vector<TetId> added;
    for (int trial = 0; trial < 30; ++trial) {
        if (trial % 10 == 9) {
            region.clear();
            added.clear();
        }
        const VertexId v(static_cast<std::uint32_t>(random.below(complex.vertex_capacity())));
        region.add_star(rated, v);
        std::set<TetId> star;
        for (const TetId t : tets(complex))
            if (complex.has_vertex(t, v)) star.insert(t);
        const std::vector<TetId> tail(region.tets().end() - static_cast<std::ptrdiff_t>(star.size()),
                                      region.tets().end());
        REQUIRE(once(tail) == star);
        for (const TetId t : tail)
            if (std::find(added.begin(), added.end(), t) == added.end()) added.push_back(t);
        region.settle(complex);
        REQUIRE(std::vector<TetId>(region.tets().begin(), region.tets().end()) == added);

        std::set<VertexId> vertices, on_interface;
        std::set<EdgeId> off, on;
        for (const TetId t : added) {
            for (const VertexId u : complex.vertices(t)) {
                vertices.insert(u);
                if (complex.is_interface(u)) on_interface.insert(u);
            }
            for (const EdgeId e : complex.edges(t))
                if (!complex.is_interface(e)) off.insert(e);
            for (const FaceId f : complex.faces(t))
                if (complex.is_interface(f)) on.insert(complex.edges(f).begin(), complex.edges(f).end());
        }
        REQUIRE(once(region.vertices(complex)) == vertices);
        REQUIRE(once(region.interface_vertices(complex)) == on_interface);
        REQUIRE(once(region.edges_off_interface(complex)) == off);
        REQUIRE(once(region.interface_edges(complex)) == on);
    }
}

TEST_CASE("what is deleted leaves the region when it is settled") {
    Mesh mesh(box({2, 2, 2}));
    Region region;
    region.assign(tets(mesh.complex()));
    const TetId gone = region.tets()[5];
    split(mesh, gone,
          0.25 * (mesh.position(mesh.complex().vertices(gone)[0]) + mesh.position(mesh.complex().vertices(gone)[1]) +
                  mesh.position(mesh.complex().vertices(gone)[2]) + mesh.position(mesh.complex().vertices(gone)[3])));
    const std::size_t before = region.tets().size();
    region.settle(mesh.complex());
    CHECK(region.tets().size() == before - (mesh.complex().is_deleted(gone) ? 1 : 0));
    for (const TetId t : region.tets()) CHECK_FALSE(mesh.complex().is_deleted(t));
}
