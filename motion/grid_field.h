// SPDX-License-Identifier: GPL-3.0-or-later
// A velocity known at the points of a regular grid, from a measurement or another program, linear in each coordinate
// between them. Outside the grid: that of the nearest place on it. Guarantee: exact for velocities that are linear in
// each coordinate; continuous. Cost: eight grid points (four in the plane).
//
//     const motion::VelocityField<3> wind = motion::grid_field<3>({origin, spacing, counts, velocities});
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "motion/velocity.h"

namespace dsc::motion {

template <int Dimension>
struct VelocityGrid {
    Vector<Dimension> origin = Vector<Dimension>::Zero();   ///< place of the first point
    Vector<Dimension> spacing = Vector<Dimension>::Ones();  ///< > 0
    std::array<std::size_t, Dimension> counts{};            ///< points in each coordinate, >= 1
    std::vector<Vector<Dimension>> velocities;              ///< the first coordinate runs fastest

    /// Throws core::UsageError that names the first field out of its range.
    void validate() const {
        std::size_t points = 1;
        for (const std::size_t count : counts) points *= count;
        if (!origin.allFinite()) throw core::UsageError("origin: has to be finite");
        if (!(spacing.minCoeff() > 0 && spacing.allFinite())) throw core::UsageError("spacing: has to be positive");
        if (points == 0) throw core::UsageError("counts: has to be at least 1 in each coordinate");
        if (velocities.size() != points) throw core::UsageError("velocities: has to be one for each point of the grid");
    }

    Vector<Dimension> velocity(const Vector<Dimension>& x) const {
        std::array<std::size_t, Dimension> lower{};
        std::array<std::size_t, Dimension> upper{};
        Vector<Dimension> share;
        for (int k = 0; k < Dimension; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const auto last = static_cast<double>(counts[i] - 1);
            const double place = std::clamp((x[k] - origin[k]) / spacing[k], 0.0, last);
            lower[i] = static_cast<std::size_t>(place);
            upper[i] = std::min(lower[i] + 1, counts[i] - 1);
            share[k] = place - std::floor(place);
        }
        Vector<Dimension> sum = Vector<Dimension>::Zero();
        for (unsigned corner = 0; corner < 1u << Dimension; ++corner) {
            std::size_t index = 0;
            double weight = 1;
            for (int k = Dimension - 1; k >= 0; --k) {
                const auto i = static_cast<std::size_t>(k);
                const bool is_upper = (corner >> k & 1u) != 0;
                index = index * counts[i] + (is_upper ? upper[i] : lower[i]);
                weight *= is_upper ? share[k] : 1 - share[k];
            }
            if (weight > 0) sum += weight * velocities[index];
        }
        return sum;
    }
};

/// Throws core::UsageError for a grid that is not valid. A place that is not finite has no velocity (NaN).
template <int Dimension>
VelocityField<Dimension> grid_field(VelocityGrid<Dimension> grid) {
    grid.validate();
    return [grid = std::make_shared<const VelocityGrid<Dimension>>(std::move(grid))](const Vector<Dimension>& x,
                                                                                     double) -> Vector<Dimension> {
        if (!x.allFinite()) return Vector<Dimension>::Constant(std::nan(""));
        return grid->velocity(x);
    };
}

}  // namespace dsc::motion
