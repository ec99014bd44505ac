// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes of a VTK data array one after the other, whatever they are packed in, without unpacking the whole.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace dsc::io::tet {

class ByteSource {
public:
    virtual ~ByteSource() = default;
    /// Fills `bytes` with the next ones; false when there are fewer or when they are damaged.
    virtual bool read(std::span<char> bytes) = 0;
};

/// The bytes as they are; the view has to outlive the source.
std::unique_ptr<ByteSource> raw_bytes(std::string_view bytes);

/// Base64, with blanks anywhere; several encoded pieces, each with its padding, may follow one another.
std::unique_ptr<ByteSource> base64_bytes(std::string_view text);

/// What a zlib stream of its own for each block expands to.
struct PackedBlock {
    std::uint64_t size = 0;  ///< expanded
    std::uint64_t packed_size = 0;
};
std::unique_ptr<ByteSource> inflated_bytes(std::unique_ptr<ByteSource> packed, std::vector<PackedBlock> blocks);

/// Whether zlib can have packed a block so well.
bool is_possible(const PackedBlock& block);

}  // namespace dsc::io::tet
