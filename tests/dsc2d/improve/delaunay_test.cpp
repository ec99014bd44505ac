// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/improve/delaunay.h"

#include "core/random.h"
#include "dsc2d/generate/locate.h"
#include "dsc2d/generate/structured.h"
#include "tests/dsc2d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc2d;
using dsc::tests::require_valid;

namespace {

void check_delaunay(const Domain& domain, std::uint64_t seed) {
    Complex complex = structured_complex(domain, 3, 3);
    dsc::core::Random random(seed);
    for (int i = 0; i < 150; ++i)
        insert_point(complex, domain.snapped(domain.origin() + domain.basis() * Point2(random.uniform(0.01, 0.99),
                                                                                       random.uniform(0.01, 0.99))));
    require_valid(complex);
    CHECK(DelaunayPass(complex).run_everywhere(complex) > 100);
    require_valid(complex);
    int not_delaunay = 0;
    for (std::uint32_t e = 0; e < complex.edge_capacity(); ++e)
        not_delaunay += is_locally_delaunay(complex, EdgeId(e)) ? 0 : 1;
    CHECK(not_delaunay == 0);
    CHECK(DelaunayPass(complex).run_everywhere(complex) == 0);
}

}  // namespace

TEST_CASE("Lawson's flips end in a Delaunay triangulation") {
    check_delaunay(Domain::box({0, 0}, {1, 1}), dsc::tests::seed(13));
    check_delaunay(Domain::torus(Eigen::Matrix2d::Identity()), dsc::tests::seed(14));
    check_delaunay(Domain::cylinder({1, 0}, {0.2, 0.6}), dsc::tests::seed(15));
}

TEST_CASE("many cocircular points make no endless flips") {
    Complex complex = structured_complex(Domain::box({-1, -1}, {1, 1}), 2, 2);
    for (const Point2& p : dsc::tests::circle({0.1, 0.1}, 0.5, 64)) insert_point(complex, complex.domain().snapped(p));
    DelaunayPass(complex).run_everywhere(complex);
    require_valid(complex);
}
