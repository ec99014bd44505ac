// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of VTK's XML formats have in common: the document, and its arrays as streams of numbers, written as
// text, as inline base64 or appended, packed by ZLib or not.
// Source: the VTK file formats document, "XML file formats". Guarantee: what is wrong throws core::InputError with the
// file, the place and the cure. Cost: appended data are not copied.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "io/tet/number_stream.h"

namespace dsc::io::tet {

class VtkXml {
public:
    /// Reads the file, which has to be a VTK file of this type ("UnstructuredGrid"); `save_again` is the cure for what
    /// is not as it should be.
    VtkXml(const std::filesystem::path& path, const char* type, std::string save_again);
    VtkXml(const VtkXml&) = delete;
    VtkXml& operator=(const VtkXml&) = delete;

    /// The element with the name of the type.
    pugi::xml_node grid() const { return root_.child(type_); }
    /// The piece of the grid; several ones are refused with `cure`.
    pugi::xml_node only_piece(const char* problem, const char* cure) const;
    /// The stream of an array that holds `count` numbers, or as many as there are.
    std::unique_ptr<NumberStream> open(pugi::xml_node array, std::optional<std::uint64_t> count) const;

    [[noreturn]] void fail(const std::string& place, const std::string& problem, const std::string& cure) const;
    /// ... with the cure given to the constructor.
    [[noreturn]] void fail(const std::string& place, const std::string& problem) const;

private:
    struct Appended {
        bool is_base64 = false;
        std::string_view bytes;    ///< empty when there are none
        std::size_t xml_size = 0;  ///< of the document that stands before
    };

    static Appended cut_off_appended(std::string& text);
    [[noreturn]] void reject_xml(const pugi::xml_parse_result& result) const;
    [[noreturn]] void reject_count(const std::string& name, std::uint64_t found, std::uint64_t expected) const;
    void read_head();
    std::unique_ptr<NumberStream> open_binary(pugi::xml_node array, const std::string& name) const;
    std::string_view appended_at(pugi::xml_node array, const std::string& name) const;
    std::uint64_t read_header(ByteSource& bytes, const std::string& name) const;
    std::vector<PackedBlock> read_block_sizes(ByteSource& bytes, std::uint64_t room, const std::string& name) const;

    std::filesystem::path path_;
    const char* type_;
    std::string save_again_;
    std::string text_;  ///< changed by the parser, which leaves names and values in it
    Appended appended_;
    pugi::xml_document document_;
    pugi::xml_node root_;
    std::endian order_ = std::endian::little;
    bool has_long_headers_ = false;
    bool is_compressed_ = false;
};

}  // namespace dsc::io::tet
