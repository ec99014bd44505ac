// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/indicators.h"

#include <cmath>
#include <numbers>

#include "dsc3d/improve/angle_range.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;

namespace {

Mesh shaken_mesh(Random& random) {
    TetData data = box({3, 3, 3});
    shake_inside(data, 0.4, random);
    return Mesh(data);
}

}  // namespace

TEST_CASE("the indicators are the worst quality and the means of qualities cut off at seven sines") {
    Random random(seed(1));
    Mesh mesh = shaken_mesh(random);
    mesh.complex().replace(std::array{TetId(5)}, {});  // a gap in the handles
    for (const QualityMeasure measure : {QualityMeasure::minimum_sine, QualityMeasure::volume_length}) {
        const RatedMesh rated(mesh, measure, {});
        const QualityIndicators indicators(rated);
        std::vector<double> qualities;
        for (const TetId t : tets(mesh.complex())) qualities.push_back(rated.rate(mesh.complex().vertices(t)));
        CHECK(indicators.worst == *std::min_element(qualities.begin(), qualities.end()));
        std::size_t k = 0;
        for (const double degrees : {1, 5, 10, 15, 25, 35, 45}) {
            const double threshold = std::sin(degrees * std::numbers::pi / 180);
            double sum = 0;
            for (const double quality : qualities) sum += std::min(quality, threshold);
            CHECK(indicators.means[k++] == Approx(sum / static_cast<double>(qualities.size())).epsilon(1e-12));
        }
    }
}

TEST_CASE("one indicator that has gained enough makes a mesh better") {
    Random random(seed(2));
    Mesh mesh = shaken_mesh(random);
    const RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    const QualityIndicators before(rated);
    CHECK_FALSE(before.is_better_than(before, 1e-4));
    QualityIndicators now = before;
    now.worst += 2e-4;
    CHECK(now.is_better_than(before, 1e-4));
    for (std::size_t k = 0; k < before.means.size(); ++k) {
        now = before;
        now.worst -= 0.1;
        now.means[k] += 2e-4;
        CHECK(now.is_better_than(before, 1e-4));
        CHECK_FALSE(now.is_better_than(before, 3e-4));
    }
}

TEST_CASE("what was lost and is won back is no gain over the best so far") {
    Random random(seed(4));
    Mesh mesh = shaken_mesh(random);
    const RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    const QualityIndicators first(rated);
    for (std::size_t k = 0; k < first.means.size(); ++k) {
        // One indicator falls while another rises, then the other way round.
        QualityIndicators up = first, down = first;
        up.means[k] += 1e-3, up.worst -= 1e-3;
        down.means[k] -= 1e-3, down.worst += 1e-3;
        QualityIndicators reached = first;
        reached.raise_to(up);
        CHECK(reached.worst == first.worst);
        CHECK(reached.means == up.means);
        CHECK(down.is_better_than(reached, 1e-4));
        reached.raise_to(down);
        CHECK(down.is_better_than(up, 1e-4));
        CHECK(up.is_better_than(down, 1e-4));
        CHECK_FALSE(up.is_better_than(reached, 1e-4));
        CHECK_FALSE(down.is_better_than(reached, 1e-4));
        up.worst = reached.worst + 2e-4;
        CHECK(up.is_better_than(reached, 1e-4));
    }
}

TEST_CASE("the range of dihedral angles is that of all tetrahedra") {
    Random random(seed(3));
    const Mesh mesh = shaken_mesh(random);
    double least = 10, largest = 0;
    for (const TetId t : tets(mesh.complex())) {
        const TetVertices& v = mesh.complex().vertices(t);
        for (const double angle : dsc::geometry::dihedral_angles(mesh.position(v[0]), mesh.position(v[1]),
                                                                 mesh.position(v[2]), mesh.position(v[3]))) {
            least = std::min(least, angle);
            largest = std::max(largest, angle);
        }
    }
    const AngleRange range(mesh);
    CHECK(range.min == Approx(least).epsilon(1e-12));
    CHECK(range.max == Approx(largest).epsilon(1e-12));
    const AngleRange of_cubes(Mesh(box({2, 1, 1})));
    CHECK(of_cubes.min == Approx(std::numbers::pi / 4));
    CHECK(of_cubes.max == Approx(std::numbers::pi / 2));
}
