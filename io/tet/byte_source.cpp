// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/byte_source.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace dsc::io::tet {

namespace {

class RawBytes : public ByteSource {
public:
    explicit RawBytes(std::string_view bytes) : rest_(bytes) {}

    bool read(std::span<char> bytes) override {
        if (bytes.size() > rest_.size()) return false;
        std::copy_n(rest_.begin(), bytes.size(), bytes.begin());
        rest_.remove_prefix(bytes.size());
        return true;
    }

private:
    std::string_view rest_;
};

// Bytes that come in pieces, whose size is not that of what is read.
class PiecewiseBytes : public ByteSource {
public:
    bool read(std::span<char> bytes) final {
        while (!bytes.empty()) {
            if (piece_.empty() && !unpack(piece_)) return false;
            const std::size_t count = std::min(bytes.size(), piece_.size());
            std::copy_n(piece_.begin(), count, bytes.begin());
            piece_.remove_prefix(count);
            bytes = bytes.subspan(count);
        }
        return true;
    }

private:
    /// The next piece, valid until the call after; false when there is none or it is damaged.
    virtual bool unpack(std::string_view& piece) = 0;

    std::string_view piece_;
};

constexpr unsigned char no_digit = 255;

constexpr std::array<unsigned char, 256> base64_digits() {
    std::array<unsigned char, 256> digits{};
    digits.fill(no_digit);
    unsigned char value = 0;
    for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")) {
        digits[static_cast<unsigned char>(c)] = value++;
    }
    return digits;
}

class Base64Bytes : public PiecewiseBytes {
public:
    explicit Base64Bytes(std::string_view text) : rest_(text) {}

private:
    // Four digits make three bytes; one or two signs of padding at the end make that fewer.
    bool unpack(std::string_view& piece) override {
        static constexpr std::array<unsigned char, 256> digits = base64_digits();
        std::uint32_t bits = 0;
        std::size_t padding = 0;
        for (int k = 0; k < 4; ++k) {
            while (!rest_.empty() && static_cast<unsigned char>(rest_.front()) <= ' ') rest_.remove_prefix(1);
            if (rest_.empty()) return false;
            const char c = rest_.front();
            const unsigned char digit = digits[static_cast<unsigned char>(c)];
            if (c == '=' && k >= 2) {
                ++padding;
            } else if (digit == no_digit || padding > 0) {
                return false;
            }
            bits = bits << 6 | (c == '=' ? 0u : digit);
            rest_.remove_prefix(1);
        }
        for (std::size_t k = 0; k < 3; ++k) group_[k] = static_cast<char>(bits >> (16 - 8 * k) & 255);
        piece = std::string_view(group_.data(), 3 - padding);
        return true;
    }

    std::string_view rest_;
    std::array<char, 3> group_{};
};

class InflatedBytes : public PiecewiseBytes {
public:
    InflatedBytes(std::unique_ptr<ByteSource> packed, std::vector<PackedBlock> blocks)
        : packed_(std::move(packed)), blocks_(std::move(blocks)) {}

private:
    bool unpack(std::string_view& piece) override {
        if (next_ == blocks_.size()) return false;
        const PackedBlock& block = blocks_[next_++];
        std::string packed(block.packed_size, '\0');
        if (!packed_->read(packed)) return false;
        block_.resize(block.size);
        auto size = static_cast<uLongf>(block.size);
        const int status = ::uncompress(reinterpret_cast<Bytef*>(block_.data()), &size,
                                        reinterpret_cast<const Bytef*>(packed.data()), packed.size());
        piece = block_;
        return status == Z_OK && size == block.size && !block_.empty();
    }

    std::unique_ptr<ByteSource> packed_;
    std::vector<PackedBlock> blocks_;
    std::size_t next_ = 0;
    std::string block_;
};

}  // namespace

std::unique_ptr<ByteSource> raw_bytes(std::string_view bytes) { return std::make_unique<RawBytes>(bytes); }

std::unique_ptr<ByteSource> base64_bytes(std::string_view text) { return std::make_unique<Base64Bytes>(text); }

std::unique_ptr<ByteSource> inflated_bytes(std::unique_ptr<ByteSource> packed, std::vector<PackedBlock> blocks) {
    return std::make_unique<InflatedBytes>(std::move(packed), std::move(blocks));
}

bool is_possible(const PackedBlock& block) {
    constexpr std::uint64_t best_ratio = 1032;  // zlib's documentation: "the limit (1032:1)"
    return block.size / best_ratio <= block.packed_size;
}

}  // namespace dsc::io::tet
