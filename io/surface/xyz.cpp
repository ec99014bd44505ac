// SPDX-License-Identifier: GPL-3.0-or-later
// Points as columns of numbers.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "io/atomic_file.h"
#include "io/surface/formats.h"
#include "io/text_scanner.h"

namespace dsc::io::surface {

namespace {

// Of "0 0 0" and the end of its line.
constexpr std::size_t least_row_bytes = 6;

/// Rows of as many columns as the first one has.
class XyzReader {
public:
    explicit XyzReader(TextScanner scanner) : scanner_(std::move(scanner)) {}

    geometry::PointData read() {
        if (scanner_.at_end()) return {};
        count_columns();
        const std::size_t rows = most_rows();
        data_.points.reserve(rows);
        if (has_normals()) data_.normals.reserve(rows);
        while (!scanner_.at_end()) read_row();
        return std::move(data_);
    }

private:
    bool has_normals() const { return columns_ >= 6; }

    void count_columns() {
        TextScanner ahead = scanner_;
        for (; !ahead.at_line_end(); ++columns_) ahead.word("a number");
        if (columns_ == 3 || columns_ >= 6) return;
        ahead.fail("the number of columns is " + std::to_string(columns_), "use 3, or 6 and more with normals");
    }

    // Growing step by step would need up to three times the memory of the data.
    std::size_t most_rows() const {
        const std::string_view text = scanner_.rest();
        const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
        return std::min(lines, text.size() / least_row_bytes + 1);
    }

    void read_row() {
        column_ = 0;
        data_.points.push_back(read_vector());
        if (has_normals()) data_.normals.push_back(read_vector());
        while (column_ < columns_) {
            begin_column();
            scanner_.word("a number");
        }
        if (!scanner_.at_line_end()) reject_row();
    }

    Eigen::Vector3d read_vector() {
        Eigen::Vector3d v;
        for (double& x : v) {
            begin_column();
            x = scanner_.real("a coordinate");
        }
        return v;
    }

    void begin_column() {
        if (scanner_.at_line_end()) reject_row();
        ++column_;
    }

    [[noreturn]] void reject_row() {
        for (; !scanner_.at_line_end(); ++column_) scanner_.word("a number");
        scanner_.fail("the number of columns is " + std::to_string(column_) + ", but " + std::to_string(columns_) +
                          " in the lines before",
                      "correct the line");
    }

    TextScanner scanner_;
    std::size_t columns_ = 0;
    std::size_t column_ = 0;  // how many of the row have been read
    geometry::PointData data_;
};

bool are_colors(const std::vector<Eigen::Vector3d>& vectors) {
    bool has_more_than_unit = false;
    for (const Eigen::Vector3d& v : vectors) {
        for (const double x : v) {
            if (x < 0 || x > 255 || x != std::floor(x)) return false;
            has_more_than_unit = has_more_than_unit || x > 1;
        }
    }
    return has_more_than_unit;
}

}  // namespace

geometry::PointData read_xyz(const std::filesystem::path& path) {
    std::string text = read_file(path);
    std::ranges::replace(text, ',', ' ');
    geometry::PointData data = XyzReader(TextScanner(path.string(), text, {.comment = '#'})).read();
    if (are_colors(data.normals)) data.normals = {};
    return data;
}

}  // namespace dsc::io::surface
