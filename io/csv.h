// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers as CSV: a header line and rows of doubles, written atomically (io/atomic_file.h).
// Guarantee: with 17 digits (the default) every number reads back as the same double; whole numbers have no point.
//
//     io::CsvWriter table("locus.csv", {"u", "v", "distance"});
//     table.row({u, v, distance});
//     table.commit();
#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "io/atomic_file.h"

namespace dsc::io {

class CsvWriter {
public:
    CsvWriter(const std::filesystem::path& path, std::span<const std::string> columns, int digits = 17);
    CsvWriter(const std::filesystem::path& path, std::initializer_list<std::string> columns, int digits = 17);

    /// One value per column.
    void row(std::span<const double> values);
    void row(std::initializer_list<double> values);
    void commit() { file_.commit(); }

private:
    AtomicFile file_;
    std::size_t columns_;
    int digits_;
    std::string line_;
};

/// A table of finite numbers: a header line, then one row of `columns.size()` numbers per line. Blank lines and lines
/// that begin with '#' are skipped.
struct CsvTable {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;
    std::vector<std::size_t> lines;  ///< of the file that the rows stand in, from 1 on: for messages
};

/// Reads a CSV file; a first line that consists of numbers only counts as a row, the columns then have no names.
/// Throws core::InputError naming file and line for anything that is not a finite number or not as wide as the header.
CsvTable read_csv(const std::filesystem::path& path);

}  // namespace dsc::io
