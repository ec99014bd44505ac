// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes and files for the tests of the formats of tetrahedral meshes.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>
#include <utility>

#include "core/errors.h"
#include "core/random.h"
#include "io/atomic_file.h"
#include "io/tet_mesh.h"
#include "tests/support/temporary_folder.h"

namespace dsc::tests {

inline double signed_volume(const geometry::TetData& data, std::size_t tet) {
    const auto corner = [&](std::size_t k) { return data.vertices[data.tets[tet][k]]; };
    const Eigen::Vector3d a = corner(0);
    return (corner(1) - a).cross(corner(2) - a).dot(corner(3) - a) / 6;
}

/// A cube of `cells`³ boxes of six positive tetrahedra, the vertices moved at random, with labels from -3 to 6.
inline geometry::TetData random_mesh(core::Random& random, std::uint32_t cells, bool has_labels = true) {
    const std::uint32_t side = cells + 1;
    geometry::TetData data;
    const auto moved = [&](std::uint32_t i) { return (i + random.uniform(-0.2, 0.2)) / 3; };
    for (std::uint32_t i = 0; i < side * side * side; ++i) {
        const double x = moved(i / side / side);
        const double y = moved(i / side % side);
        const double z = moved(i % side);
        data.vertices.emplace_back(x, y, z);
    }
    const std::uint32_t step[] = {side * side, side, 1};
    for (std::uint32_t corner = 0; corner < side * side * side; ++corner) {
        if (corner / step[0] == cells || corner / side % side == cells || corner % side == cells) continue;
        int axes[] = {0, 1, 2};
        do {
            const std::uint32_t b = corner + step[axes[0]];
            const std::uint32_t c = b + step[axes[1]];
            data.tets.push_back({corner, b, c, c + step[axes[2]]});
            if (signed_volume(data, data.tets.size() - 1) < 0) std::swap(data.tets.back()[0], data.tets.back()[1]);
            if (has_labels) data.labels.push_back(static_cast<int>(random.below(10)) - 3);
        } while (std::next_permutation(std::begin(axes), std::end(axes)));
    }
    return data;
}

inline bool same_coordinates(const geometry::TetData& a, const geometry::TetData& b) {
    return a.vertices.size() == b.vertices.size() &&
           std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Eigen::Vector3d)) == 0;
}

/// In ascending order of labels, else as it was: as formats have it that group by label.
inline geometry::TetData sorted_by_label(const geometry::TetData& data) {
    if (data.labels.empty()) return data;
    std::vector<std::size_t> order(data.tets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return data.labels[a] < data.labels[b]; });
    geometry::TetData sorted{.vertices = data.vertices, .tets = {}, .labels = {}};
    for (const std::size_t i : order) {
        sorted.tets.push_back(data.tets[i]);
        sorted.labels.push_back(data.labels[i]);
    }
    return sorted;
}

/// Reads `text` as a file of that name in a folder of its own.
inline geometry::TetData read_text(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    io::write_file(folder / name, text);
    return io::read_tet_mesh(folder / name).data;
}

/// The message of the core::InputError that reading throws, without the folder; empty when there is none.
inline std::string reading_error(const std::filesystem::path& path) {
    try {
        io::read_tet_mesh(path);
    } catch (const core::InputError& error) {
        const std::string message = error.what();
        const std::string folder = path.parent_path().string() + "/";
        return message.starts_with(folder) ? message.substr(folder.size()) : "not in the folder: " + message;
    }
    return "";
}

inline std::string error_of(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    io::write_file(folder / name, text);
    return reading_error(folder / name);
}

/// `text` with the first `what` replaced, which has to be there.
inline std::string with(std::string text, const std::string& what, const std::string& replacement) {
    return text.replace(text.find(what), what.size(), replacement);
}

}  // namespace dsc::tests
