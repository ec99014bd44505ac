// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/csv.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "core/assert.h"
#include "core/errors.h"
#include "io/number.h"

namespace dsc::io {

CsvWriter::CsvWriter(const std::filesystem::path& path, std::span<const std::string> columns, int digits)
    : file_(path), columns_(columns.size()), digits_(digits) {
    for (const std::string& column : columns) line_ += (line_.empty() ? "" : ",") + column;
    file_.write(line_ + "\n");
}

CsvWriter::CsvWriter(const std::filesystem::path& path, std::initializer_list<std::string> columns, int digits)
    : CsvWriter(path, std::span<const std::string>(columns.begin(), columns.size()), digits) {}

void CsvWriter::row(std::span<const double> values) {
    DSC_ASSERT(values.size() == columns_);
    line_.clear();
    for (const double value : values) {
        append_number(line_, value, digits_);
        line_ += ',';
    }
    if (!line_.empty()) line_.back() = '\n';
    file_.write(line_);
}

void CsvWriter::row(std::initializer_list<double> values) {
    row(std::span<const double>(values.begin(), values.size()));
}

namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        fields.push_back(trimmed(line.substr(begin, end - begin)));
        begin = end + 1;
    }
    return fields;
}

// The numbers of a line, or the first field that is none.
std::vector<double> numbers_of(std::span<const std::string_view> fields, std::optional<std::string_view>& wrong) {
    std::vector<double> numbers;
    for (const std::string_view field : fields) {
        const std::optional<double> value = parse_finite(field);
        if (!value) {
            wrong = field;
            return {};
        }
        numbers.push_back(*value);
    }
    return numbers;
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    CsvTable table;
    std::size_t width = 0;
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
        ++number;
        if (line.empty() || line.front() == '#') continue;

        const std::vector<std::string_view> fields = fields_of(line);
        const auto place = [&] { return "line " + std::to_string(number); };
        std::optional<std::string_view> wrong;
        const std::vector<double> numbers = numbers_of(fields, wrong);
        if (width != 0 && fields.size() != width) {
            throw core::InputError(
                path.string(), place(),
                std::to_string(fields.size()) + " values where " + std::to_string(width) + " are expected",
                "separate them by commas");
        }
        if (width == 0 && wrong) {
            table.columns.assign(fields.begin(), fields.end());
        } else if (wrong) {
            throw core::InputError(path.string(), place(), "\"" + std::string(*wrong) + "\" is not a finite number",
                                   "");
        } else {
            table.rows.push_back(numbers);
            table.lines.push_back(number);
        }
        width = fields.size();
    }
    return table;
}

}  // namespace dsc::io
