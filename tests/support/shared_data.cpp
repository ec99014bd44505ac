// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/shared_data.h"

#include <cstdlib>

namespace dsc::tests {

std::filesystem::path source_folder() { return DSC_SOURCE_DIR; }

std::filesystem::path shared_data(const std::string& name) {
    const char* folder = std::getenv("DSC_SHARED_DATA");
    const std::filesystem::path root =
        folder != nullptr ? std::filesystem::path(folder) : source_folder().parent_path() / "shared" / "data";
    return root / name;
}

}  // namespace dsc::tests
