// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a complex against an independent reconstruction from its list of tetrahedra alone: the sets of faces and
// edges, the boundary relation and its order, the partial coboundary, flags, orientation and manifoldness. Cost: n log
// n; it works in Release too.
#pragma once

#include <string>
#include <vector>

#include "dsc3d/complex/complex.h"

namespace dsc::dsc3d {

/// One line per violation, at most `limit`; empty when everything holds.
std::vector<std::string> validate(const Complex& complex, std::size_t limit = 20);

}  // namespace dsc::dsc3d
