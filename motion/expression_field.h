// SPDX-License-Identifier: GPL-3.0-or-later
// Velocities given as text: "(-y, x, 0)", one expression for each coordinate in x, y, z (x, y in the plane), the time
// t, pi and e, by muParser: + - * / ^ ( ), comparisons, && ||, c ? a : b, and sin, cos, tan, asin, acos, atan, atan2,
// sinh, cosh, tanh, exp, log (natural), log10, log2, sqrt, abs, sign, rint, min, max, sum, avg. The parentheses around
// the whole may be left out. Guarantee: safe to call from many threads; deterministic; what is not finite is for the
// caller to find. Cost: some 10 ns per operation.
//
//     const motion::RungeKuttaFlow<3> flow(motion::expression_field<3>("(-y, x, 0)"));
#pragma once

#include <string_view>

#include "motion/velocity.h"

namespace dsc::motion {

/// Throws core::InputError with the column of what can't be read, with `source` as its source. Dimension is 2 or 3.
template <int Dimension>
VelocityField<Dimension> expression_field(std::string_view text, std::string_view source = "--velocity");

extern template VelocityField<2> expression_field<2>(std::string_view text, std::string_view source);
extern template VelocityField<3> expression_field<3>(std::string_view text, std::string_view source);

}  // namespace dsc::motion
