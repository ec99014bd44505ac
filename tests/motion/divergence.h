// SPDX-License-Identifier: GPL-3.0-or-later
// Divergence by central differences, for tests.
#pragma once

#include "motion/velocity.h"

namespace dsc::tests {

template <int Dimension>
double divergence(const motion::VelocityField<Dimension>& field, const motion::Vector<Dimension>& x, double t,
                  double h) {
    double sum = 0;
    for (int k = 0; k < Dimension; ++k) {
        const motion::Vector<Dimension> step = h * motion::Vector<Dimension>::Unit(k);
        sum += (field(x + step, t)[k] - field(x - step, t)[k]) / (2 * h);
    }
    return sum;
}

}  // namespace dsc::tests
