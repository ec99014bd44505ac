// SPDX-License-Identifier: GPL-3.0-or-later
// A JSON value: built by programs for their reports, read back by tests and later runs.
// Guarantee: the members of an object keep the order in which they were added; a finite number reads back as the same
// double or integer; a double that is not finite is written as null, since JSON has no such number.
//
//     io::Json report = io::Json::object();
//     report["length"] = 12.5;
//     report["vertices"].push_back(io::Json::object({{"kind", "branch"}, {"degree", 3}}));
//     io::write_file("report.json", report.dump(2));
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace dsc::io {

class Json {
public:
    using Array = std::vector<Json>;
    using Member = std::pair<std::string, Json>;
    using Object = std::vector<Member>;

    Json() = default;
    Json(std::nullptr_t) {}
    Json(bool value) : value_(value) {}
    Json(std::integral auto value) : value_(static_cast<std::int64_t>(value)) {}
    Json(double value) : value_(value) {}
    Json(const char* text) : value_(std::string(text)) {}
    Json(std::string text) : value_(std::move(text)) {}
    Json(std::string_view text) : value_(std::string(text)) {}
    Json(std::span<const double> numbers);
    Json(const std::vector<double>& numbers) : Json(std::span<const double>(numbers)) {}

    static Json array(Array values = {});
    static Json object(Object members = {});

    /// Reads a whole text; throws core::InputError with `source`, line and column when it is not JSON.
    static Json parse(std::string_view text, const std::string& source = "JSON");

    bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
    bool is_number() const;
    bool is_array() const { return std::holds_alternative<Array>(value_); }
    bool is_object() const { return std::holds_alternative<Object>(value_); }
    bool is_string() const { return std::holds_alternative<std::string>(value_); }

    /// The value as what it is; throws core::InputError when it is something else.
    bool boolean() const;
    double number() const;
    std::int64_t integer() const;
    const std::string& string() const;
    const Array& elements() const;
    const Object& members() const;

    /// Number of elements or members; 0 for everything else.
    std::size_t size() const;
    bool has(std::string_view key) const;

    /// The member `key`; the reading form throws core::InputError when it is absent, the writing one adds it (and makes
    /// an object of null). A reference is valid until a member is added.
    const Json& operator[](std::string_view key) const;
    Json& operator[](std::string_view key);
    const Json& operator[](std::size_t index) const;
    Json& operator[](std::size_t index);

    /// Appends an element (and makes an array of null).
    void push_back(Json value);

    /// The text; one line for indent < 0. Arrays of numbers stay on one line.
    std::string dump(int indent = -1, int digits = 17) const;

    bool operator==(const Json&) const = default;

private:
    void append_to(std::string& text, int indent, int depth, int digits) const;

    std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> value_;
};

}  // namespace dsc::io
