// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of its own for one test, removed at the end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dsc::tests {

class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    /// The names of what is in it, sorted.
    std::vector<std::string> content() const;

private:
    std::filesystem::path path_;
};

}  // namespace dsc::tests
