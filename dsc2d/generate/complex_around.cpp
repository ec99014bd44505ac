// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/generate/complex_around.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/structured.h"

namespace dsc::dsc2d {

void FillParameters::validate() const {
    if (!(cell > 0)) throw core::UsageError("cell: has to be positive");
    if (max_cells < 4) throw core::UsageError("max_cells: has to be at least 4");
    if (sweeps < 0) throw core::UsageError("sweeps: has to be at least 0");
}

Complex complex_around(const Domain& domain, std::span<const Region> regions, double edge_length,
                       const FillParameters& parameters, const core::Observer& observer) {
    parameters.validate();
    const auto cells = [&](int direction) {
        const double count = domain.basis().col(direction).norm() / (parameters.cell * edge_length);
        return static_cast<int>(std::lround(std::clamp(count, 4.0, static_cast<double>(parameters.max_cells))));
    };
    Complex complex = structured_complex(domain, cells(0), cells(1));
    insert_regions(complex, regions, observer);
    Parameters improvement = {.edge_length = edge_length, .topology = motion::TopologyPolicy::preserved};
    improvement.smoothing_sweeps = 2;
    improvement.poor_angle = 25 * std::numbers::pi / 180;
    improvement.needle_angle = 20 * std::numbers::pi / 180;
    improvement.needle_min_length = 2;
    Deformer deformer(complex, improvement);
    for (int sweep = 0; sweep < parameters.sweeps; ++sweep) {
        observer.check_cancelled();
        deformer.improve_everywhere();
    }
    complex.compact();
    return complex;
}

}  // namespace dsc::dsc2d
