// SPDX-License-Identifier: GPL-3.0-or-later
// Points, lines and polygons for ParaView: one VTP file, or a series over time with its PVD index.
// Guarantee: every file appears whole or not at all; coordinates are not rounded.
//
//     io::PvdSeries fronts("fronts", "front");
//     fronts.add(time, {.points = positions, .lines = {{0, 1, 2, 0}}});
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "io/vtk_array.h"

namespace dsc::io {

/// Cells are numbered dots first, then lines, then polygons; cell data follow that order.
struct PolyData {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::uint32_t> dots;                ///< points to be shown as such
    std::vector<std::vector<std::uint32_t>> lines;  ///< a closed line repeats its first point
    std::vector<std::vector<std::uint32_t>> polygons;
    std::vector<VtkData> point_data;
    std::vector<VtkData> cell_data;
};

/// The text of a VTP file. The lengths of all data arrays and all indices have to fit.
std::string vtp_text(const PolyData& data, VtkEncoding encoding = VtkEncoding::binary);
void write_vtp(const std::filesystem::path& path, const PolyData& data, VtkEncoding encoding = VtkEncoding::binary);

/// FOLDER/STEM.pvd and FOLDER/STEM_0000.vtp, …: the index is complete after every add(), so that a run that was ended
/// early can be looked at.
class PvdSeries {
public:
    /// Creates the folder if its parent exists; throws core::InputError when nothing can be written there.
    PvdSeries(std::filesystem::path folder, std::string stem, VtkEncoding encoding = VtkEncoding::binary);

    void add(double time, const PolyData& data);
    std::filesystem::path index() const;

private:
    std::filesystem::path folder_;
    std::string stem_;
    VtkEncoding encoding_;
    std::string entries_;
    std::size_t count_ = 0;
};

}  // namespace dsc::io
