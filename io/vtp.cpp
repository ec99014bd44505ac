// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtp.h"

#include "core/assert.h"
#include "io/atomic_file.h"
#include "io/number.h"
#include "io/xml.h"

namespace dsc::io {

namespace {

void append_cells(std::string& text, const std::string& element, const std::vector<std::vector<std::uint32_t>>& cells,
                  [[maybe_unused]] std::size_t point_count, VtkEncoding encoding) {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;
    for (const auto& cell : cells) {
        for (const std::uint32_t index : cell) {
            DSC_ASSERT(index < point_count);
            connectivity.push_back(index);
        }
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
    text += "<" + element + ">\n";
    append_vtk_array(text, "connectivity", connectivity, encoding);
    append_vtk_array(text, "offsets", offsets, encoding);
    text += "</" + element + ">\n";
}

void append_data(std::string& text, const std::string& element, const std::vector<VtkData>& arrays,
                 [[maybe_unused]] std::size_t count, VtkEncoding encoding) {
    if (arrays.empty()) return;
    text += "<" + element + ">\n";
    for (const VtkData& array : arrays) {
        DSC_ASSERT(array.values.size() == count * static_cast<std::size_t>(array.components));
        append_vtk_array(text, array.name, array.components, array.values, encoding);
    }
    text += "</" + element + ">\n";
}

}  // namespace

std::string vtp_text(const PolyData& data, VtkEncoding encoding) {
    std::vector<double> coordinates;
    coordinates.reserve(3 * data.points.size());
    for (const Eigen::Vector3d& p : data.points) coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
    std::vector<std::vector<std::uint32_t>> dots;
    for (const std::uint32_t dot : data.dots) dots.push_back({dot});

    const std::size_t point_count = data.points.size();
    std::string text = "<Piece NumberOfPoints=\"" + std::to_string(point_count) + "\" NumberOfVerts=\"" +
                       std::to_string(dots.size()) + "\" NumberOfLines=\"" + std::to_string(data.lines.size()) +
                       "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(data.polygons.size()) + "\">\n";
    append_data(text, "PointData", data.point_data, point_count, encoding);
    append_data(text, "CellData", data.cell_data, dots.size() + data.lines.size() + data.polygons.size(), encoding);
    text += "<Points>\n";
    append_vtk_array(text, "Points", 3, coordinates, encoding);
    text += "</Points>\n";
    append_cells(text, "Verts", dots, point_count, encoding);
    append_cells(text, "Lines", data.lines, point_count, encoding);
    append_cells(text, "Polys", data.polygons, point_count, encoding);
    text += "</Piece>\n";
    return vtk_document("PolyData", text);
}

void write_vtp(const std::filesystem::path& path, const PolyData& data, VtkEncoding encoding) {
    write_file(path, vtp_text(data, encoding));
}

PvdSeries::PvdSeries(std::filesystem::path folder, std::string stem, VtkEncoding encoding)
    : folder_(std::move(folder)), stem_(std::move(stem)), encoding_(encoding) {
    require_writable_folder(folder_);
}

std::filesystem::path PvdSeries::index() const { return folder_ / (stem_ + ".pvd"); }

void PvdSeries::add(double time, const PolyData& data) {
    std::string number = std::to_string(count_++);
    if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
    const std::string name = stem_ + "_" + number + ".vtp";
    write_vtp(folder_ / name, data, encoding_);
    entries_ += "<DataSet timestep=\"" + number_text(time) + "\" part=\"0\" file=\"" + xml_escaped(name) + "\"/>\n";
    write_file(index(),
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
               "byte_order=\"LittleEndian\">\n<Collection>\n" +
                   entries_ + "</Collection>\n</VTKFile>\n");
}

}  // namespace dsc::io
