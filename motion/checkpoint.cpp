// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes: magic, format, kind, version; then for each entry its name, type, number of values and values; at the end
// the FNV-1a checksum of all before. A string is its length (64 bits) and its bytes.
#include "motion/checkpoint.h"

#include <bit>
#include <istream>
#include <iterator>
#include <ostream>

#include "core/errors.h"

namespace dsc::motion {

namespace {

constexpr std::string_view magic = "DSCstate";
constexpr std::uint32_t format = 1;
constexpr std::size_t checksum_size = 8;
constexpr std::uint8_t text_type = 'T';

template <CheckpointNumber T>
constexpr std::uint8_t type_of() {
    if constexpr (std::same_as<T, double>) return 'd';
    if constexpr (std::same_as<T, std::int32_t>) return 'i';
    if constexpr (std::same_as<T, std::int64_t>) return 'l';
    if constexpr (std::same_as<T, std::uint8_t>) return 'B';
    if constexpr (std::same_as<T, std::uint32_t>) return 'I';
    if constexpr (std::same_as<T, std::uint64_t>) return 'L';
}

void append_number(std::string& bytes, std::uint64_t value, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) bytes.push_back(static_cast<char>(value >> 8 * k & 0xFF));
}

void append_string(std::string& bytes, std::string_view text) {
    append_number(bytes, text.size(), 8);
    bytes += text;
}

std::uint64_t number_at(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        value |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << 8 * k;
    }
    return value;
}

template <CheckpointNumber T>
std::uint64_t image(T value) {
    if constexpr (std::same_as<T, double>) {
        return std::bit_cast<std::uint64_t>(value);
    } else {
        return static_cast<std::uint64_t>(value);
    }
}

template <CheckpointNumber T>
T from_image(std::uint64_t bits) {
    if constexpr (std::same_as<T, double>) {
        return std::bit_cast<double>(bits);
    } else {
        return static_cast<T>(bits);
    }
}

// Any single byte that differs gives another sum: each step is one-to-one.
std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t sum = 0xCBF29CE484222325ULL;
    for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
    return sum;
}

}  // namespace

CheckpointWriter::CheckpointWriter(std::string_view kind, std::uint32_t version) : bytes_(magic) {
    append_number(bytes_, format, 4);
    append_string(bytes_, kind);
    append_number(bytes_, version, 4);
}

template <CheckpointNumber T>
void CheckpointWriter::add_array(std::string_view name, std::span<const T> values) {
    append_string(bytes_, name);
    append_number(bytes_, type_of<T>(), 1);
    append_number(bytes_, values.size(), 8);
    for (const T value : values) append_number(bytes_, image(value), sizeof(T));
}

void CheckpointWriter::add_text(std::string_view name, std::string_view text) {
    append_string(bytes_, name);
    append_number(bytes_, text_type, 1);
    append_string(bytes_, text);
}

void CheckpointWriter::write(std::ostream& stream) const {
    std::string end;
    append_number(end, checksum(bytes_), checksum_size);
    stream.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    stream.write(end.data(), static_cast<std::streamsize>(end.size()));
    stream.flush();
    if (!stream) throw core::RunError("the checkpoint can't be written");
}

CheckpointReader::CheckpointReader(std::istream& stream, std::string source, std::string_view kind,
                                   std::uint32_t version)
    : source_(std::move(source)), bytes_(std::istreambuf_iterator<char>(stream), {}) {
    if (!bytes_.starts_with(magic)) fail("", "is no checkpoint");
    const std::size_t least = magic.size() + 4 + checksum_size;
    if (bytes_.size() < least) fail("", "is cut off");
    const std::size_t end = bytes_.size() - checksum_size;
    if (number_at(std::string_view(bytes_).substr(end)) != checksum(std::string_view(bytes_).substr(0, end))) {
        fail("", "is damaged or cut off: its checksum is wrong");
    }
    bytes_.resize(end);
    next_ = magic.size();
    if (take_number(4) != format) fail("", "was written by another version of the program");
    if (const std::string found = take_string(); found != kind) fail("", "is a checkpoint of '" + found + "'");
    if (const std::uint64_t found = take_number(4); found != version) {
        fail("", "has version " + std::to_string(found) + " where " + std::to_string(version) + " is read");
    }
}

template <CheckpointNumber T>
std::vector<T> CheckpointReader::array(std::string_view name) {
    const std::string_view bytes = entry(name, type_of<T>(), sizeof(T));
    std::vector<T> values(bytes.size() / sizeof(T));
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = from_image<T>(number_at(bytes.substr(i * sizeof(T), sizeof(T))));
    }
    return values;
}

template <CheckpointNumber T>
std::vector<T> CheckpointReader::array(std::string_view name, std::size_t count) {
    std::vector<T> values = array<T>(name);
    if (values.size() != count) {
        fail("entry '" + std::string(name) + "'",
             "has " + std::to_string(values.size()) + " values where " + std::to_string(count) + " are expected");
    }
    return values;
}

std::string CheckpointReader::text(std::string_view name) { return std::string(entry(name, text_type, 1)); }

void CheckpointReader::require_end() const {
    if (next_ != bytes_.size()) fail("", "has more entries than expected");
}

void CheckpointReader::fail(const std::string& place, const std::string& problem) const {
    throw core::InputError(source_, place, problem, "start anew, or resume from another checkpoint");
}

std::string_view CheckpointReader::take(std::size_t size) {
    if (size > bytes_.size() - next_) fail("", "has fewer entries than expected");
    const std::string_view bytes = std::string_view(bytes_).substr(next_, size);
    next_ += size;
    return bytes;
}

std::uint64_t CheckpointReader::take_number(std::size_t size) { return number_at(take(size)); }

std::string CheckpointReader::take_string() { return std::string(take(take_number(8))); }

std::string_view CheckpointReader::entry(std::string_view name, std::uint8_t type, std::size_t size_of_value) {
    const std::string place = "entry '" + std::string(name) + "'";
    if (const std::string found = take_string(); found != name) fail(place, "there is '" + found + "' in its place");
    if (take_number(1) != type) fail(place, "has another type");
    const std::uint64_t count = take_number(8);
    if (count > (bytes_.size() - next_) / size_of_value) fail(place, "has fewer values than it announces");
    return take(count * size_of_value);
}

#define DSC_CHECKPOINT_NUMBER(T)                                                        \
    template void CheckpointWriter::add_array<T>(std::string_view, std::span<const T>); \
    template std::vector<T> CheckpointReader::array<T>(std::string_view);               \
    template std::vector<T> CheckpointReader::array<T>(std::string_view, std::size_t)
DSC_CHECKPOINT_NUMBER(double);
DSC_CHECKPOINT_NUMBER(std::int32_t);
DSC_CHECKPOINT_NUMBER(std::int64_t);
DSC_CHECKPOINT_NUMBER(std::uint8_t);
DSC_CHECKPOINT_NUMBER(std::uint32_t);
DSC_CHECKPOINT_NUMBER(std::uint64_t);
#undef DSC_CHECKPOINT_NUMBER

}  // namespace dsc::motion
