// SPDX-License-Identifier: GPL-3.0-or-later
// Files for the tests of the formats of surfaces and points.
#pragma once

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/points.h"
#include "io/surface_mesh.h"
#include "tests/support/temporary_folder.h"

namespace dsc::tests {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

inline bool same_bits(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

/// Reads `text` as a file of that name in a folder of its own.
inline geometry::SurfaceData surface_in(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    io::write_file(folder / name, text);
    return io::read_surface_mesh(folder / name);
}

inline geometry::PointData points_in(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    io::write_file(folder / name, text);
    return io::read_points(folder / name);
}

/// The message of the core::InputError that `read(path)` throws, without the folder; empty when there is none.
template <class Read>
std::string input_error(const std::filesystem::path& path, const Read& read) {
    try {
        read(path);
    } catch (const core::InputError& error) {
        const std::string message = error.what();
        const std::string folder = path.parent_path().string() + "/";
        return message.starts_with(folder) ? message.substr(folder.size()) : "not in the folder: " + message;
    }
    return "";
}

/// The same for `text` as a file of that name.
inline std::string surface_error(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    io::write_file(folder / name, text);
    return input_error(folder / name, io::read_surface_mesh);
}

inline std::string points_error(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    io::write_file(folder / name, text);
    return input_error(folder / name, io::read_points);
}

/// `text` with the first `what` replaced, which has to be there.
inline std::string replaced(std::string text, const std::string& what, const std::string& replacement) {
    return text.replace(text.find(what), what.size(), replacement);
}

/// The bytes of the number, of either byte order.
template <class Number>
std::string bytes_of(Number number, bool is_big_endian = false) {
    const std::string image(reinterpret_cast<const char*>(&number), sizeof number);
    return is_big_endian ? std::string(image.rbegin(), image.rend()) : image;
}

}  // namespace dsc::tests
