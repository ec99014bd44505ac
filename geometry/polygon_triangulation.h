// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation of a polygon whose worst triangle is best, by dynamic programming.
// Source: Klincsek (1980), "Minimal triangulations of polygonal domains"; thesis 3.2.2, 3.3.1.
// Guarantee: optimal among all triangulations of the polygon by its own vertices. Cost: n^3 / 6 weights; no allocation.
//
//     PolygonTriangulation<16> best(n, threshold, [&](int i, int j, int k) { return quality_of_triangle(i, j, k); });
//     if (best.is_possible()) best.for_each_triangle([&](int i, int j, int k) { use(i, j, k); });
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/assert.h"

namespace dsc::geometry {

template <int MaxVertices>
class PolygonTriangulation {
public:
    /// `weight(i, j, k)` of the triangle i < j < k, larger is better; triangles of at most `threshold` are not used.
    /// Precondition: 2 <= vertices <= MaxVertices.
    template <class Weight>
    PolygonTriangulation(int vertices, double threshold, Weight&& weight) : vertices_(vertices) {
        DSC_ASSERT(vertices >= 2 && vertices <= MaxVertices);
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (int i = 0; i + 1 < vertices; ++i) best(i, i + 1) = infinity;
        for (int span = 2; span < vertices; ++span) {
            for (int i = 0; i + span < vertices; ++i) {
                const int k = i + span;
                double& value = best(i, k);
                value = -infinity;
                for (int j = i + 1; j < k; ++j) {
                    const double parts = std::min(best(i, j), best(j, k));
                    if (parts <= value || parts <= threshold) continue;
                    const double worst = std::min(parts, static_cast<double>(weight(i, j, k)));
                    if (worst <= value || worst <= threshold) continue;
                    value = worst;
                    apex(i, k) = static_cast<std::uint8_t>(j);
                }
            }
        }
    }

    /// The worst weight of the best triangulation; minus infinity when every one is at or below the threshold.
    double value() const { return best_[index(0, vertices_ - 1)]; }
    bool is_possible() const { return value() > -std::numeric_limits<double>::infinity(); }

    /// Calls use(i, j, k), i < j < k, for the vertices - 2 triangles. Precondition: is_possible().
    template <class Use>
    void for_each_triangle(Use&& use) const {
        visit(0, vertices_ - 1, use);
    }

private:
    static_assert(MaxVertices <= 256);
    static constexpr std::size_t index(int i, int k) { return static_cast<std::size_t>(i * MaxVertices + k); }
    double& best(int i, int k) { return best_[index(i, k)]; }
    std::uint8_t& apex(int i, int k) { return apex_[index(i, k)]; }

    template <class Use>
    void visit(int i, int k, Use& use) const {
        if (k - i < 2) return;
        const int j = apex_[index(i, k)];
        visit(i, j, use);
        use(i, j, k);
        visit(j, k, use);
    }

    int vertices_;
    std::array<double, static_cast<std::size_t>(MaxVertices) * MaxVertices> best_;
    std::array<std::uint8_t, static_cast<std::size_t>(MaxVertices) * MaxVertices> apex_;
};

}  // namespace dsc::geometry
