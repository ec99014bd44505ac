// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/csv.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "core/random.h"
#include "tests/support/seed.h"
#include "tests/support/temporary_folder.h"

using namespace dsc::io;
using dsc::tests::TemporaryFolder;

TEST_CASE("a table is read back as the same numbers") {
    const TemporaryFolder folder;
    dsc::core::Random random(dsc::tests::seed(2));
    std::vector<std::vector<double>> rows;
    CsvWriter writer(folder / "t.csv", {"u", "v", "arc"});
    for (int i = 0; i < 5000; ++i) {
        rows.push_back({random.uniform(-1e3, 1e3), random.uniform() * 1e-12, static_cast<double>(i)});
        writer.row(rows.back());
    }
    writer.commit();
    const CsvTable table = read_csv(folder / "t.csv");
    CHECK(table.columns == std::vector<std::string>{"u", "v", "arc"});
    CHECK(table.rows == rows);
}

TEST_CASE("a table without header, with blank lines, comments and spaces is read") {
    const TemporaryFolder folder;
    write_file(folder / "t.csv", "# points\n\n 0.5 , -1\r\n2,3\n");
    const CsvTable table = read_csv(folder / "t.csv");
    CHECK(table.columns.empty());
    CHECK(table.rows == std::vector<std::vector<double>>{{0.5, -1}, {2, 3}});
    CHECK(table.lines == std::vector<std::size_t>{3, 4});
    write_file(folder / "empty.csv", "");
    CHECK(read_csv(folder / "empty.csv").rows.empty());
}

TEST_CASE("a wrong table is refused with file and line") {
    const TemporaryFolder folder;
    for (const char* text :
         {"u,v\n1,2\n1,nan\n", "u,v\n1,2\n1,x\n", "u,v\n1,2\n1\n", "u,v\n1,2\n1,2,\n", "1,2\n3,4\n,\n"}) {
        INFO(text);
        write_file(folder / "t.csv", text);
        CHECK_THROWS_WITH(read_csv(folder / "t.csv"), Catch::Contains("t.csv: line 3"));
    }
}
