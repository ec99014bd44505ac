// SPDX-License-Identifier: GPL-3.0-or-later
// All triangulations of a convex polygon by its own vertices, one by one: what an optimum over them is compared with.
// There are Catalan(n - 2) of them: 1, 2, 5, 14, 42, 132 for n = 3 .. 8.
#pragma once

#include <array>
#include <limits>
#include <vector>

namespace dsc::tests {

/// The worst of no triangle; its negative is the best of no triangulation.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

using Triangulation = std::vector<std::array<int, 3>>;  ///< triangles i < j < k

/// Those of the vertices i, i + 1, .. k; one without triangles when there are two vertices.
inline std::vector<Triangulation> triangulations(int i, int k) {
    if (k - i < 2) return {{}};
    std::vector<Triangulation> all;
    for (int j = i + 1; j < k; ++j) {
        for (const Triangulation& left : triangulations(i, j)) {
            for (const Triangulation& right : triangulations(j, k)) {
                Triangulation one = left;
                one.push_back({i, j, k});
                one.insert(one.end(), right.begin(), right.end());
                all.push_back(one);
            }
        }
    }
    return all;
}

/// Of the polygon 0 .. n - 1.
inline std::vector<Triangulation> triangulations(int n) { return triangulations(0, n - 1); }

}  // namespace dsc::tests
