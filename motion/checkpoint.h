// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a run as bytes, from which it goes on bit for bit: named arrays of numbers and texts, in the order in
// which they are written.
// Guarantee: doubles are kept exactly, on any machine (little endian); a file that was cut, changed or made for
// something else is refused before anything of it is used. Cost: one pass; the whole is kept in memory. Putting the
// bytes in place of the last checkpoint, whole or not at all, is for the program (io/atomic_file.h).
//
//     motion::CheckpointWriter out("flow", 1);             motion::CheckpointReader in(stream, "run/checkpoint",
//     "flow", 1); out.add("time", t);                                  const double t = in.number("time");
//     out.add_array<std::int32_t>("labels", labels);       const auto labels = in.array<std::int32_t>("labels");
//     out.write(stream);                                   in.require_end();
#pragma once

#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dsc::motion {

template <class T>
concept CheckpointNumber = std::same_as<T, double> || std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t> ||
    std::same_as<T, std::uint8_t> || std::same_as<T, std::uint32_t> || std::same_as<T, std::uint64_t>;

class CheckpointWriter {
public:
    /// What the state is of, and the version of how it is written.
    CheckpointWriter(std::string_view kind, std::uint32_t version);

    template <CheckpointNumber T>
    void add_array(std::string_view name, std::span<const T> values);
    template <CheckpointNumber T>
    void add(std::string_view name, T value) {
        add_array<T>(name, std::span(&value, 1));
    }
    void add_text(std::string_view name, std::string_view text);

    /// All of it with its checksum. Throws core::RunError when the stream fails.
    void write(std::ostream& stream) const;

private:
    std::string bytes_;
};

class CheckpointReader {
public:
    /// Reads the stream to its end. Throws core::InputError with `source` as its source when it is not a whole
    /// checkpoint of this kind and version.
    CheckpointReader(std::istream& stream, std::string source, std::string_view kind, std::uint32_t version);

    /// The next entry, which has to have this name and type: core::InputError otherwise.
    template <CheckpointNumber T>
    std::vector<T> array(std::string_view name);
    /// ... and so many values.
    template <CheckpointNumber T>
    std::vector<T> array(std::string_view name, std::size_t count);
    template <CheckpointNumber T>
    T value(std::string_view name) {
        return array<T>(name, 1).front();
    }
    double number(std::string_view name) { return value<double>(name); }
    std::string text(std::string_view name);

    /// Throws core::InputError when entries are left.
    void require_end() const;

    /// Throws core::InputError: what was read is not what it should be.
    [[noreturn]] void fail(const std::string& place, const std::string& problem) const;

private:
    std::string_view take(std::size_t size);
    std::uint64_t take_number(std::size_t size);
    std::string take_string();
    /// The bytes of the next entry.
    std::string_view entry(std::string_view name, std::uint8_t type, std::size_t size_of_value);

    std::string source_;
    std::string bytes_;
    std::size_t next_ = 0;
};

}  // namespace dsc::motion
