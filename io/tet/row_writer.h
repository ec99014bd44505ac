// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers, as all text formats of meshes have them. Coordinates read back as the same double.
#pragma once

#include <Eigen/Core>
#include <charconv>
#include <concepts>
#include <filesystem>
#include <string>
#include <string_view>

#include "io/atomic_file.h"
#include "io/number.h"

namespace dsc::io::tet {

class RowWriter {
public:
    explicit RowWriter(const std::filesystem::path& path) : file_(path) {}

    AtomicFile& file() { return file_; }

    void text(std::string_view text) { file_.write(text); }
    /// The numbers and points, separated by blanks, and the end of the line.
    template <class... Values>
    void row(const Values&... values) {
        line_.clear();
        (append(values), ...);
        line_.back() = '\n';
        file_.write(line_);
    }

private:
    template <std::integral T>
    void append(T value) {
        char digits[24];
        line_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
        line_ += ' ';
    }
    void append(const Eigen::Vector3d& p) {
        for (const double x : p) {
            append_number(line_, x);
            line_ += ' ';
        }
    }

    AtomicFile file_;
    std::string line_;
};

}  // namespace dsc::io::tet
