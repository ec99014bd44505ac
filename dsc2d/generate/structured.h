// SPDX-License-Identifier: GPL-3.0-or-later
// A structured triangulation of a domain: columns x rows cells, two triangles each, all with label 0.
// Source: thesis 4.3 (initial mesh). Guarantee: a valid complex whose vertices cover the domain evenly. Cost: linear.
#pragma once

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

/// Columns go along basis().col(0), rows along basis().col(1). Throws core::UsageError unless both are at least 1, and
/// at least 3 in a periodic direction.
Complex structured_complex(const Domain& domain, int columns, int rows);

}  // namespace dsc::dsc2d
