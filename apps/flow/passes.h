// SPDX-License-Identifier: GPL-3.0-or-later
// The passes of a deformation step by name, to do without one of them (thesis ch. 7 asks what each is worth).
#pragma once

#include <string>
#include <vector>

#include "dsc3d/deform/parameters.h"

namespace dsc::flow {

std::vector<std::string> pass_names();

/// Switches off the passes of a list, "smoothing,escapes". Throws core::UsageError that names --without for a name that
/// is none.
void switch_off(const std::string& list, dsc3d::DeformParameters& parameters);

}  // namespace dsc::flow
