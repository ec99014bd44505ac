// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/vtk_xml.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>

#include "core/errors.h"
#include "io/atomic_file.h"

namespace dsc::io::tet {

namespace {

constexpr const char* damaged = "get the file again, whole";

std::optional<NumberType> number_type(std::string_view name) {
    static const std::map<std::string_view, NumberType> types = {
        {"Int8", NumberType::int8},       {"UInt8", NumberType::uint8},   {"Int16", NumberType::int16},
        {"UInt16", NumberType::uint16},   {"Int32", NumberType::int32},   {"UInt32", NumberType::uint32},
        {"Int64", NumberType::int64},     {"UInt64", NumberType::uint64}, {"Float32", NumberType::float32},
        {"Float64", NumberType::float64},
    };
    const auto found = types.find(name);
    if (found == types.end()) return {};
    return found->second;
}

}  // namespace

// Appended data need not be XML: their tag is overwritten by the end of the document, for the parser to stop there.
VtkXml::Appended VtkXml::cut_off_appended(std::string& text) {
    constexpr std::string_view tag = "<AppendedData";
    constexpr std::string_view end_tag = "</VTKFile>";
    static_assert(end_tag.size() <= tag.size());
    const std::size_t begin = text.find(tag);
    if (begin == text.npos) return {.xml_size = text.size()};
    const std::string_view section = std::string_view(text).substr(begin);
    const std::size_t mark = std::min(section.find('_'), section.size());
    Appended data{.is_base64 = section.substr(0, mark).find("base64") != section.npos,
                  .xml_size = begin + end_tag.size()};
    const std::size_t end = section.rfind("</AppendedData");
    if (mark < end && end < section.size()) data.bytes = section.substr(mark + 1, end - mark - 1);
    std::ranges::copy(end_tag, text.begin() + static_cast<std::ptrdiff_t>(begin));
    return data;
}

VtkXml::VtkXml(const std::filesystem::path& path, const char* type, std::string save_again)
    : path_(path),
      type_(type),
      save_again_(std::move(save_again)),
      text_(read_file(path)),
      appended_(cut_off_appended(text_)) {
    const pugi::xml_parse_result result =
        document_.load_buffer_inplace(text_.data(), appended_.xml_size, pugi::parse_escapes, pugi::encoding_utf8);
    if (!result) reject_xml(result);
    read_head();
}

void VtkXml::fail(const std::string& place, const std::string& problem, const std::string& cure) const {
    throw core::InputError(path_.string(), place, problem, cure);
}

void VtkXml::fail(const std::string& place, const std::string& problem) const { fail(place, problem, save_again_); }

// Parsing has changed the text, so that the line is found in the file once more.
void VtkXml::reject_xml(const pugi::xml_parse_result& result) const {
    const std::string text = read_file(path_);
    const auto offset = std::min(static_cast<std::size_t>(result.offset), text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
    std::string problem = result.description();
    problem.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(problem.front())));
    fail("line " + std::to_string(line), "is no XML: " + problem, damaged);
}

void VtkXml::read_head() {
    root_ = document_.child("VTKFile");
    const std::string_view type = root_.attribute("type").value();
    if (type != type_) fail("", std::string("is no VTK file of type ") + type_);
    if (std::string_view(root_.attribute("byte_order").value()) == "BigEndian") order_ = std::endian::big;
    has_long_headers_ = std::string_view(root_.attribute("header_type").value()) == "UInt64";
    const std::string compressor = root_.attribute("compressor").value();
    is_compressed_ = !compressor.empty();
    if (is_compressed_ && compressor != "vtkZLibDataCompressor") {
        fail("", "is compressed by " + in_quotes(compressor), "save it with the compressor ZLib or none");
    }
}

pugi::xml_node VtkXml::only_piece(const char* problem, const char* cure) const {
    const pugi::xml_node piece = grid().child("Piece");
    if (!piece) fail("", "has no element Piece");
    if (piece.next_sibling("Piece")) fail("", problem, cure);
    return piece;
}

std::unique_ptr<NumberStream> VtkXml::open(pugi::xml_node array, std::optional<std::uint64_t> count) const {
    const std::string name = "array " + in_quotes(array.attribute("Name").value());
    const std::string_view format = array.attribute("format").value();
    std::unique_ptr<NumberStream> stream;
    if (format.empty() || format == "ascii") {
        stream = text_numbers(TextScanner(path_.string(), array.text().get(), {.within = name}));
    } else if (format == "binary" || format == "appended") {
        stream = open_binary(array, name);
        if (count && stream->most() != *count) reject_count(name, stream->most(), *count);
    } else {
        fail(name, "has the format " + in_quotes(format));
    }
    if (count && stream->most() < *count) reject_count(name, stream->most(), *count);
    return stream;
}

void VtkXml::reject_count(const std::string& name, std::uint64_t found, std::uint64_t expected) const {
    fail(name, "has " + std::to_string(found) + " numbers where " + std::to_string(expected) + " are announced",
         damaged);
}

std::unique_ptr<NumberStream> VtkXml::open_binary(pugi::xml_node array, const std::string& name) const {
    const std::optional<NumberType> type = number_type(array.attribute("type").value());
    if (!type) fail(name, "has the type " + in_quotes(array.attribute("type").value()));
    const bool is_inline = std::string_view(array.attribute("format").value()) == "binary";
    const std::string_view packed = is_inline ? array.text().get() : appended_at(array, name);
    const bool is_base64 = is_inline || appended_.is_base64;
    const std::uint64_t room = is_base64 ? packed.size() / 4 * 3 : packed.size();
    std::unique_ptr<ByteSource> bytes = is_base64 ? base64_bytes(packed) : raw_bytes(packed);

    std::uint64_t size = 0;
    if (is_compressed_) {
        std::vector<PackedBlock> blocks = read_block_sizes(*bytes, room, name);
        for (const PackedBlock& block : blocks) size += block.size;
        bytes = inflated_bytes(std::move(bytes), std::move(blocks));
    } else {
        size = read_header(*bytes, name);
        if (size > room) fail(name, "the data ends before " + std::to_string(size) + " bytes", damaged);
    }
    if (size % size_of(*type) != 0) fail(name, "the size of the data fits no numbers", damaged);
    return binary_numbers({path_.string(), name, *type, order_, size / size_of(*type)}, std::move(bytes));
}

std::string_view VtkXml::appended_at(pugi::xml_node array, const std::string& name) const {
    const std::uint64_t offset = array.attribute("offset").as_ullong(std::numeric_limits<std::uint64_t>::max());
    if (offset >= appended_.bytes.size()) fail(name, "the appended data ends before its offset", damaged);
    return appended_.bytes.substr(offset);
}

// One number of the header before the data.
std::uint64_t VtkXml::read_header(ByteSource& bytes, const std::string& name) const {
    std::array<char, 8> image{};
    const std::span<char> used(image.data(), has_long_headers_ ? 8 : 4);
    if (!bytes.read(used)) fail(name, "the data ends within its header", damaged);
    if (order_ != std::endian::little) std::reverse(used.begin(), used.end());
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < 8; ++k) value |= std::uint64_t{static_cast<unsigned char>(image[k])} << 8 * k;
    return value;
}

std::vector<PackedBlock> VtkXml::read_block_sizes(ByteSource& bytes, std::uint64_t room,
                                                  const std::string& name) const {
    const std::uint64_t count = read_header(bytes, name);
    const std::uint64_t size = read_header(bytes, name);
    const std::uint64_t last_size = read_header(bytes, name);  // 0 when it is full
    if (count > room) fail(name, "the data ends within its header", damaged);
    std::vector<PackedBlock> blocks;
    for (std::uint64_t i = 0; i < count; ++i) {
        const bool is_partial = i + 1 == count && last_size != 0;
        const PackedBlock block{.size = is_partial ? last_size : size, .packed_size = read_header(bytes, name)};
        if (block.packed_size > room || !is_possible(block)) {
            fail(name, "a compressed block has a wrong size", damaged);
        }
        room -= block.packed_size;
        blocks.push_back(block);
    }
    return blocks;
}

}  // namespace dsc::io::tet
