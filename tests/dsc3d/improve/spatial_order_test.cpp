// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/spatial_order.h"

#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;

namespace {

// A box whose vertices are numbered at random.
TetData mixed_box(std::uint32_t n, Random& random) {
    TetData data = box({n, n, n});
    std::vector<std::uint32_t> number(data.vertices.size());
    for (std::uint32_t i = 0; i < number.size(); ++i) number[i] = i;
    for (std::size_t i = number.size(); i-- > 1;) std::swap(number[i], number[random.below(i + 1)]);
    const auto vertices = data.vertices;
    for (std::size_t i = 0; i < number.size(); ++i) data.vertices[number[i]] = vertices[i];
    for (auto& tet : data.tets)
        for (std::uint32_t& v : tet) v = number[v];
    return data;
}

double mean_distance_in_numbers(const Complex& complex) {
    double sum = 0;
    for (const EdgeId e : edges(complex)) {
        const auto [a, b] = complex.vertices(e);
        sum += std::abs(static_cast<double>(a.index()) - static_cast<double>(b.index()));
    }
    return sum / complex.edge_count();
}

}  // namespace

TEST_CASE("in spatial order the ends of an edge have near numbers, and restoring brings everything back") {
    Random random(seed(1));
    const TetData data = mixed_box(12, random);
    Mesh mesh(data);
    const double mixed = mean_distance_in_numbers(mesh.complex());
    SpatialOrder order(mesh);
    require_valid(mesh);
    CHECK(mean_distance_in_numbers(mesh.complex()) < mixed / 4);
    order.restore();
    require_valid(mesh);
    CHECK(mesh.data().tets == data.tets);
    CHECK(mesh.data().vertices == data.vertices);
}

TEST_CASE("what has stayed comes back in its order, what has come follows") {
    Random random(seed(2));
    const TetData data = mixed_box(3, random);
    Mesh mesh(data);
    SpatialOrder order(mesh);
    // One tetrahedron makes room for another one, made of the same vertices.
    const TetId t(random.below(mesh.complex().tet_capacity()));
    const TetVertices v = mesh.complex().vertices(t);
    mesh.complex().replace(std::array{t}, std::array{NewTet{{v[1], v[2], v[0], v[3]}, 7}});
    order.restore();
    require_valid(mesh);
    const TetData after = mesh.data();
    CHECK(after.vertices == data.vertices);
    CHECK(after.labels.back() == 7);
    std::vector<std::array<std::uint32_t, 4>> rest = data.tets;
    const auto last = after.tets.back();
    std::erase_if(rest, [&](const auto& tet) { return std::is_permutation(tet.begin(), tet.end(), last.begin()); });
    REQUIRE(rest.size() + 1 == data.tets.size());
    CHECK(std::equal(rest.begin(), rest.end(), after.tets.begin(), after.tets.end() - 1));
}
