// SPDX-License-Identifier: GPL-3.0-or-later
// Points as columns of numbers.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/atomic_file.h"
#include "io/number.h"
#include "io/surface/formats.h"
#include "io/text_scanner.h"

namespace dsc::io::surface {

namespace {

// Of "0 0 0" and the end of its line.
constexpr std::size_t least_row_bytes = 6;

/// Rows of as many columns as the first one has; before them, perhaps, their count or the names of the columns.
class XyzReader {
public:
    explicit XyzReader(TextScanner scanner) : scanner_(std::move(scanner)) {}

    geometry::PointData read() {
        read_head();
        if (scanner_.at_end()) return {};
        count_columns();
        const std::size_t rows = most_rows();
        data_.points.reserve(rows);
        has_normals_ = std::ranges::find(roles_, nx) != roles_.end();
        if (has_normals_) data_.normals.reserve(rows);
        while (!scanner_.at_end()) read_row();
        if (count_ && *count_ != data_.points.size())
            scanner_.fail("there are " + std::to_string(data_.points.size()) + " points, but " +
                              std::to_string(*count_) + " in the line before them",
                          "correct the count, or give the whole file");
        return std::move(data_);
    }

private:
    enum Role { x, y, z, nx, ny, nz, ignored };

    void read_head() {
        TextScanner ahead = scanner_;
        if (ahead.at_end()) return;
        std::vector<std::string_view> words{ahead.word("a number")};
        while (!ahead.at_line_end()) words.push_back(ahead.word("a number"));
        const std::optional<double> first = parse_finite(words.front());
        if (words.size() == 1 && first && *first >= 0 && *first == std::floor(*first)) {
            count_ = static_cast<std::size_t>(std::min(*first, 1e15));
        } else if (std::ranges::none_of(words, [](std::string_view w) { return parse_finite(w).has_value(); })) {
            name_columns(ahead, words);
        } else {
            return;
        }
        scanner_ = ahead;
    }

    void name_columns(const TextScanner& at, const std::vector<std::string_view>& words) {
        constexpr std::array<std::string_view, 6> names{"x", "y", "z", "nx", "ny", "nz"};
        std::array<std::size_t, names.size()> times{};
        roles_.assign(words.size(), ignored);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const auto found = std::ranges::find(names, plain(words[i]));
            if (found == names.end()) continue;
            roles_[i] = static_cast<Role>(found - names.begin());
            ++times[roles_[i]];
        }
        if (times[x] != 1 || times[y] != 1 || times[z] != 1)
            at.fail("the names of the columns are not x, y and z, once each", "name them so, or leave the line out");
        if (times[nx] != 1 || times[ny] != 1 || times[nz] != 1)
            std::ranges::replace_if(
                roles_, [](Role role) { return role > z; }, ignored);
    }

    // Of a name with quotes, or with the slashes that make a comment elsewhere.
    static std::string plain(std::string_view name) {
        std::string result;
        for (const char c : name) {
            if (c != '"' && c != '\'' && c != '/')
                result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
        return result;
    }

    void count_columns() {
        if (!roles_.empty()) return;
        TextScanner ahead = scanner_;
        std::size_t columns = 0;
        for (; !ahead.at_line_end(); ++columns) ahead.word("a number");
        // After a count the fourth column is the strength of the echo, alone or before a colour.
        const bool may_have_others = count_ && columns > 3;
        if (columns != 3 && columns < 6 && !may_have_others)
            ahead.fail("the number of columns is " + std::to_string(columns), "use 3, or 6 and more with normals");
        const std::size_t used = columns == 6 || (columns > 6 && !count_) ? 6 : 3;
        for (std::size_t i = 0; i < columns; ++i) roles_.push_back(i < used ? static_cast<Role>(i) : ignored);
    }

    // Growing step by step would need up to three times the memory of the data.
    std::size_t most_rows() const {
        const std::string_view text = scanner_.rest();
        const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
        return std::min(lines, text.size() / least_row_bytes + 1);
    }

    void read_row() {
        std::array<double, 6> values{};
        for (column_ = 0; column_ < roles_.size(); ++column_) {
            if (scanner_.at_line_end()) reject_row();
            const Role role = roles_[column_];
            if (role == ignored) {
                scanner_.word("a number");
            } else {
                values[role] = scanner_.real("a coordinate");
            }
        }
        if (!scanner_.at_line_end()) reject_row();
        data_.points.emplace_back(values[x], values[y], values[z]);
        if (has_normals_) data_.normals.emplace_back(values[nx], values[ny], values[nz]);
    }

    [[noreturn]] void reject_row() {
        for (; !scanner_.at_line_end(); ++column_) scanner_.word("a number");
        scanner_.fail("the number of columns is " + std::to_string(column_) + ", but " + std::to_string(roles_.size()) +
                          " in the lines before",
                      "correct the line");
    }

    TextScanner scanner_;
    std::vector<Role> roles_;  // of the columns
    std::optional<std::size_t> count_;
    bool has_normals_ = false;
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
