// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/version.h"

namespace dsc::core {

const char* version() { return DSC_VERSION; }

}  // namespace dsc::core
