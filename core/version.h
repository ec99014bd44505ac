// SPDX-License-Identifier: GPL-3.0-or-later
// The version of the toolkit, for reports and --version.
#pragma once

namespace dsc::core {

/// "major.minor.patch", as in the root CMakeLists.txt.
const char* version();

}  // namespace dsc::core
