// SPDX-License-Identifier: GPL-3.0-or-later
// Data arrays of VTK's XML formats, shared by the writers of VTP and VTU.
// Source: the VTK file formats document, "XML file formats"; binary is inline base64 with 64-bit sizes, little endian.
// Guarantee: Float64 and Int64 (UInt8 for the types of cells), so that nothing is rounded; ASCII numbers read back as
// the same double.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dsc::io {

enum class VtkEncoding { binary, ascii };

/// Values at points or cells: `components` numbers each, one after the other.
struct VtkData {
    std::string name;
    int components = 1;
    std::vector<double> values;
};

void append_vtk_array(std::string& text, std::string_view name, int components, std::span<const double> values,
                      VtkEncoding encoding);
void append_vtk_array(std::string& text, std::string_view name, std::span<const std::int64_t> values,
                      VtkEncoding encoding);
void append_vtk_array(std::string& text, std::string_view name, std::span<const std::uint8_t> values,
                      VtkEncoding encoding);

/// A whole file of the given type ("PolyData") around its pieces; head and tail alone for one that is written in parts.
std::string vtk_document(std::string_view type, std::string_view pieces);
std::string vtk_document_head(std::string_view type);
std::string vtk_document_tail(std::string_view type);

/// `bytes` as base64 with padding.
std::string base64(std::string_view bytes);

}  // namespace dsc::io
