// SPDX-License-Identifier: GPL-3.0-or-later
// A closed cylinder of triangles: curved and plane sides that meet in sharp, curved edges.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/surface_data.h"

namespace dsc::tests {

/// Around the z axis and the origin; 6 n vertices at the rim of a lid, edges of about radius / n everywhere.
inline geometry::SurfaceData cylinder(double radius, double height, std::uint32_t n) {
    geometry::SurfaceData data;
    const auto add_ring = [&](double r, double z, std::uint32_t count, double turn) {
        const auto first = static_cast<std::uint32_t>(data.vertices.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * (i + turn) / count;
            data.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        }
        return first;
    };
    const std::uint32_t around = 6 * n;
    const std::uint32_t rows = 2 * static_cast<std::uint32_t>(std::ceil(height * n / radius / 2));
    for (std::uint32_t k = 0; k <= rows; ++k)
        add_ring(radius, height * (static_cast<double>(k) / rows - 0.5), around, k % 2 == 0 ? 0 : 0.5);
    for (std::uint32_t k = 0; k < rows; ++k)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t next = (i + 1) % around, below = k * around, above = below + around;
            const bool is_shifted = k % 2 != 0;  // the lower row, by half an edge
            data.triangles.push_back({below + i, below + next, above + (is_shifted ? next : i)});
            data.triangles.push_back({is_shifted ? below + i : below + next, above + next, above + i});
        }
    for (const bool is_top : {false, true}) {
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            data.triangles.push_back(is_top ? std::array{a, b, c} : std::array{a, c, b});
        };
        const double z = is_top ? height / 2 : -height / 2;
        std::uint32_t inner = add_ring(0, z, 1, 0);
        for (std::uint32_t k = 1; k <= n; ++k) {
            const std::uint32_t outer = k < n ? add_ring(radius * k / n, z, 6 * k, 0) : is_top ? rows * around : 0;
            for (std::uint32_t sector = 0; sector < 6; ++sector)
                for (std::uint32_t j = 0; j < k; ++j) {
                    const auto in = [&](std::uint32_t i) {
                        return inner + (k == 1 ? 0 : (sector * (k - 1) + i) % (6 * (k - 1)));
                    };
                    const auto out = [&](std::uint32_t i) { return outer + (sector * k + i) % (6 * k); };
                    add(out(j), out(j + 1), in(j));
                    if (j + 1 < k) add(in(j), out(j + 1), in(j + 1));
                }
            inner = outer;
        }
    }
    return data;
}

}  // namespace dsc::tests
