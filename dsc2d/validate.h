// SPDX-License-Identifier: GPL-3.0-or-later
// Full check of a complex, in Release too: incidence, lattice offsets, exact orientation, interface flags.
// Source: thesis 4.3 (what a deformable simplicial complex must satisfy at all times). Cost: linear.
#pragma once

#include <string>
#include <vector>

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

/// One line per violation, in canonical order; empty when the complex is valid.
std::vector<std::string> validate(const Complex& complex);

/// Sum of the face areas; equals domain().area() up to rounding [length^2].
double total_area(const Complex& complex);
/// Sum of the areas of the faces with this label [length^2].
double labelled_area(const Complex& complex, int label);

}  // namespace dsc::dsc2d
