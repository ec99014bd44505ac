// SPDX-License-Identifier: GPL-3.0-or-later
// Structs of any depth in a checkpoint: numbers, texts, vectors of space, boxes, pairs, arrays, lists and structs that
// have a list of their members (core/fields.h), by the same lists for writing and reading.
// Guarantee: numbers are kept exactly; what was written by other lists is refused. Cost: eight bytes per number.
//
//     motion::FieldWriter writer;                  motion::FieldReader reader(in, "records");
//     writer(records);                             std::vector<Record> records;
//     writer.write(out, "records");                reader(records);
//                                                  reader.require_end();
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "motion/checkpoint.h"

namespace dsc::motion {

namespace field_kinds {

template <class>
inline constexpr bool is_list = false;
template <class Value>
inline constexpr bool is_list<std::vector<Value>> = true;
template <class Value>
inline constexpr bool is_list<std::span<Value>> = true;
template <class>
inline constexpr bool is_array = false;
template <class Value, std::size_t Size>
inline constexpr bool is_array<std::array<Value, Size>> = true;
template <class>
inline constexpr bool is_pair = false;
template <class First, class Second>
inline constexpr bool is_pair<std::pair<First, Second>> = true;
template <class>
inline constexpr bool is_box = false;
template <class Scalar, int Dimension>
inline constexpr bool is_box<Eigen::AlignedBox<Scalar, Dimension>> = true;

}  // namespace field_kinds

/// Takes values apart. What an archive does with the pieces: real(value), integer(value), text(value), size(list).
template <class Archive>
class FieldVisitor {
public:
    template <class... Values>
    void operator()(Values&... values) {
        (visit(values), ...);
    }

private:
    template <class Value>
    void visit(Value& value) {
        using Plain = std::remove_const_t<Value>;
        auto& archive = static_cast<Archive&>(*this);
        if constexpr (std::floating_point<Plain>) {
            archive.real(value);
        } else if constexpr (std::integral<Plain>) {
            archive.integer(value);
        } else if constexpr (std::same_as<Plain, std::string>) {
            archive.text(value);
        } else if constexpr (field_kinds::is_list<Plain>) {
            archive.size(value);
            for (auto& one : value) visit(one);
        } else if constexpr (field_kinds::is_array<Plain> || requires { Plain::RowsAtCompileTime; }) {
            for (auto& one : value) visit(one);
        } else if constexpr (field_kinds::is_pair<Plain>) {
            (*this)(value.first, value.second);
        } else if constexpr (field_kinds::is_box<Plain>) {
            (*this)(value.min(), value.max());
        } else {
            fields(archive, value);
        }
    }
};

class FieldWriter : public FieldVisitor<FieldWriter> {
public:
    /// As three entries, whose names begin with this one.
    void write(CheckpointWriter& out, const std::string& name) const;

private:
    friend FieldVisitor<FieldWriter>;
    void real(double value) { reals_.push_back(value); }
    void integer(std::integral auto value) { integers_.push_back(static_cast<std::int64_t>(value)); }
    void text(const std::string& value) {
        size(value);
        text_ += value;
    }
    void size(const auto& list) { integer(list.size()); }

    std::vector<std::int64_t> integers_;
    std::vector<double> reals_;
    std::string text_;
};

class FieldReader : public FieldVisitor<FieldReader> {
public:
    /// Takes the next three entries. Throws core::InputError when they are not those of a FieldWriter; so do all calls
    /// when values are missing. The reader of the checkpoint has to live as long.
    FieldReader(CheckpointReader& in, const std::string& name);

    /// Throws core::InputError when values are left.
    void require_end() const;

private:
    friend FieldVisitor<FieldReader>;
    void real(double& value);
    void integer(std::integral auto& value) { value = static_cast<std::remove_reference_t<decltype(value)>>(next()); }
    void text(std::string& value);
    void size(auto& list) { list.resize(next_size()); }

    std::int64_t next();
    std::size_t next_size();
    [[noreturn]] void fail(const char* problem) const;

    const CheckpointReader& in_;
    std::string name_;
    std::vector<std::int64_t> integers_;
    std::vector<double> reals_;
    std::string text_;
    std::size_t next_integer_ = 0, next_real_ = 0, next_character_ = 0;
};

}  // namespace dsc::motion
