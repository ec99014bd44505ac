// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk_array.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include "io/number.h"
#include "io/xml.h"

namespace dsc::io {

static_assert(std::endian::native == std::endian::little, "the binary arrays are declared as little endian");

std::string base64(std::string_view bytes) {
    static constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    auto out = text.begin();
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < count; ++k)
            group |= std::uint32_t{static_cast<unsigned char>(bytes[i + k])} << (16 - 8 * k);
        for (std::size_t k = 0; k <= count; ++k)
            out[static_cast<std::ptrdiff_t>(k)] = alphabet[group >> (18 - 6 * k) & 63];
        out += 4;
    }
    return text;
}

namespace {

template <class T>
void append_array(std::string& text, std::string_view type, std::string_view name, int components,
                  std::span<const T> values, VtkEncoding encoding) {
    const bool is_binary = encoding == VtkEncoding::binary;
    text += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + xml_escaped(name) + "\" NumberOfComponents=\"" +
            std::to_string(components) + "\" format=\"" + (is_binary ? "binary" : "ascii") + "\">\n";
    if (is_binary) {
        const std::uint64_t size = values.size_bytes();
        std::string bytes(sizeof size + size, '\0');
        std::memcpy(bytes.data(), &size, sizeof size);
        if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
        text += base64(bytes);
    } else {
        const auto row = static_cast<std::size_t>(components);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if constexpr (std::is_same_v<T, double>) {
                append_number(text, values[i]);
            } else {
                text += std::to_string(values[i]);
            }
            text += (i + 1) % row == 0 ? '\n' : ' ';
        }
    }
    text += "\n</DataArray>\n";
}

}  // namespace

void append_vtk_array(std::string& text, std::string_view name, int components, std::span<const double> values,
                      VtkEncoding encoding) {
    append_array(text, "Float64", name, components, values, encoding);
}

void append_vtk_array(std::string& text, std::string_view name, std::span<const std::int64_t> values,
                      VtkEncoding encoding) {
    append_array(text, "Int64", name, 1, values, encoding);
}

void append_vtk_array(std::string& text, std::string_view name, std::span<const std::uint8_t> values,
                      VtkEncoding encoding) {
    append_array(text, "UInt8", name, 1, values, encoding);
}

std::string vtk_document_head(std::string_view type) {
    const std::string name(type);
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + name +
           "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + name + ">\n";
}

std::string vtk_document_tail(std::string_view type) { return "</" + std::string(type) + ">\n</VTKFile>\n"; }

std::string vtk_document(std::string_view type, std::string_view pieces) {
    return vtk_document_head(type) + std::string(pieces) + vtk_document_tail(type);
}

}  // namespace dsc::io
