// SPDX-License-Identifier: GPL-3.0-or-later
// The built program improve, run as a user would.
#pragma once

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "io/json.h"
#include "io/tet_mesh.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace dsc::tests {

using Arguments = std::vector<std::string>;

inline std::string joined(const Arguments& arguments) {
    std::string line = "improve";
    for (const std::string& argument : arguments) line += ' ' + argument;
    return line;
}

/// The program succeeds and says nothing on stderr; its stdout.
inline std::string improve_output(const Arguments& arguments) {
    INFO(joined(arguments));
    const ProgramResult result = run_program(DSC_IMPROVE_PROGRAM, arguments);
    CHECK(result.err.empty());
    CHECK(result.exit_code == 0);
    return result.out;
}

/// The program fails with exit code 2, nothing on stdout and one line on stderr that contains all of `words`.
inline void check_refused(const Arguments& arguments, const std::vector<std::string>& words) {
    INFO(joined(arguments));
    const ProgramResult result = run_program(DSC_IMPROVE_PROGRAM, arguments);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(result.err_lines() == 1);
    CHECK(result.err.rfind("improve: ", 0) == 0);
    for (const std::string& word : words) CHECK_THAT(result.err, Catch::Contains(word));
}

inline io::Json read_json(const std::filesystem::path& path) {
    return io::Json::parse(io::read_file(path), path.string());
}

/// Writes a mesh into the folder; its path.
inline std::string write_mesh(const TemporaryFolder& folder, const std::string& name, const geometry::TetData& data) {
    const std::filesystem::path path = folder / name;
    io::write_tet_mesh(path, data);
    return path.string();
}

}  // namespace dsc::tests
