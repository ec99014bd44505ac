// SPDX-License-Identifier: GPL-3.0-or-later
// PLY files row by row, of either encoding and with whatever elements and properties.
// Source: G. Turk, "The PLY Polygon File Format" (1994); the names of types by width from RPly and VTK.
// Guarantee: no count is believed beyond what the rest of the file has room for. What is wrong throws core::InputError
// with the line (ASCII) or the element and the number of its row (binary).
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/tet/number_stream.h"
#include "io/text_scanner.h"

namespace dsc::io::surface {

struct PlyProperty {
    std::string name;
    tet::NumberType type = tet::NumberType::float32;
    std::optional<tet::NumberType> count_type;  ///< of a list, which begins with its count
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    bool has(std::string_view property) const;
    bool has_list(std::string_view property) const;
};

/// Beyond 2^53 neighbours could not be told apart; nothing that is counted gets there.
inline bool is_whole(double value) { return std::abs(value) <= 0x1p53 && value == std::floor(value); }

/// The values of rows, one after the other.
class PlyBody {
public:
    virtual ~PlyBody() = default;

    virtual void begin_row(const PlyElement& element, std::uint64_t row) = 0;
    virtual double number(tet::NumberType type) = 0;
    virtual void skip(tet::NumberType type, std::uint64_t count) = 0;
    virtual void end_row() = 0;
    virtual void require_end() = 0;

    /// For how many of the rows there is room in the rest.
    virtual std::uint64_t room(const PlyElement& element) const = 0;
    [[noreturn]] virtual void fail(const std::string& problem, const std::string& cure) const = 0;

    std::int64_t whole(tet::NumberType type, const char* what);
    double finite(tet::NumberType type, const char* what);
};

class PlyReader {
public:
    /// Reads the head; `bytes` has to outlive the reader.
    PlyReader(const std::string& source, std::string_view bytes);

    const std::vector<PlyElement>& elements() const { return elements_; }
    PlyBody& body() { return *body_; }

    /// Throws unless there is room for as many rows of the element as announced: before anything is reserved for them.
    void require_room(const PlyElement& element) const;
    void skip_rows(const PlyElement& element);

private:
    void read_head(TextScanner& scanner);
    void read_element(TextScanner& scanner);
    void read_property(TextScanner& scanner);

    std::vector<PlyElement> elements_;
    std::string encoding_;
    std::unique_ptr<PlyBody> body_;
};

/// The columns of an element that are wanted, taken out of each of its rows.
class PlyRows {
public:
    /// `list` is the name of a wanted list, or empty.
    PlyRows(const PlyElement& element, std::span<const std::string_view> numbers, std::string_view list = {});

    /// Reads the next row: numbers()[i] is the value of the i-th wanted property, 0 when the element hasn't got it.
    void read(PlyBody& body);

    const std::vector<double>& numbers() const { return numbers_; }
    const std::vector<std::int64_t>& list() const { return list_; }

private:
    struct Step {
        const PlyProperty* property;
        std::optional<std::size_t> slot;  // in numbers_, of a wanted number
        bool is_wanted_list = false;
    };

    void read_list(PlyBody& body, const PlyProperty& property, bool is_wanted);

    const PlyElement& element_;
    std::vector<Step> steps_;
    std::vector<double> numbers_;
    std::vector<std::int64_t> list_;
    std::uint64_t row_ = 0;
};

}  // namespace dsc::io::surface
