// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/errors.h"
#include "io/number.h"

namespace dsc::io {

namespace {

[[noreturn]] void mismatch(const char* expected) {
    throw core::InputError("JSON", "", std::string("a value is not ") + expected, "");
}

Json converted(const nlohmann::ordered_json& source) {
    switch (source.type()) {
        case nlohmann::ordered_json::value_t::object: {
            Json::Object members;
            for (const auto& [key, value] : source.items()) members.emplace_back(key, converted(value));
            return Json::object(std::move(members));
        }
        case nlohmann::ordered_json::value_t::array: {
            Json::Array values;
            for (const auto& value : source) values.push_back(converted(value));
            return Json::array(std::move(values));
        }
        case nlohmann::ordered_json::value_t::string: return source.get<std::string>();
        case nlohmann::ordered_json::value_t::boolean: return source.get<bool>();
        case nlohmann::ordered_json::value_t::number_integer: return source.get<std::int64_t>();
        // An integer above 2^63 is kept as the nearest double.
        case nlohmann::ordered_json::value_t::number_unsigned:
            if (source.get<std::uint64_t>() <= INT64_MAX) return source.get<std::int64_t>();
            return source.get<double>();
        case nlohmann::ordered_json::value_t::number_float: return source.get<double>();
        default: return nullptr;
    }
}

void append_quoted(std::string& text, const std::string& value) {
    // Text that is not UTF-8 (a file name, say) must not spoil a report: the offending bytes are replaced.
    text += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void new_line(std::string& text, int indent, int depth) {
    if (indent < 0) return;
    text += '\n';
    text.append(static_cast<std::size_t>(indent * depth), ' ');
}

}  // namespace

Json::Json(std::span<const double> numbers) : value_(Array(numbers.begin(), numbers.end())) {}

Json Json::array(Array values) {
    Json json;
    json.value_ = std::move(values);
    return json;
}

Json Json::object(Object members) {
    Json json;
    json.value_ = std::move(members);
    return json;
}

Json Json::parse(std::string_view text, const std::string& source) {
    // Of two members with the same name the parser would silently keep one.
    std::vector<std::set<std::string>> open_objects;
    const auto require_unique_names = [&](int, nlohmann::ordered_json::parse_event_t event,
                                          const nlohmann::ordered_json& value) {
        using Event = nlohmann::ordered_json::parse_event_t;
        if (event == Event::object_start) open_objects.emplace_back();
        if (event == Event::object_end) open_objects.pop_back();
        if (event == Event::key && !open_objects.back().insert(value.get<std::string>()).second)
            throw core::InputError(source, "\"" + value.get<std::string>() + "\"", "is there twice", "leave one out");
        return true;
    };
    try {
        return converted(nlohmann::ordered_json::parse(text, require_unique_names));
    } catch (const nlohmann::json::parse_error& error) {
        const std::size_t offset = std::min(error.byte, text.size());
        const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n') + 1;
        throw core::InputError(source, "line " + std::to_string(line) + ", byte " + std::to_string(error.byte),
                               "is not JSON", "");
    } catch (const nlohmann::json::exception&) {
        throw core::InputError(source, "", "has a number out of range", "");
    }
}

bool Json::is_number() const {
    return std::holds_alternative<double>(value_) || std::holds_alternative<std::int64_t>(value_);
}

bool Json::boolean() const {
    if (const bool* value = std::get_if<bool>(&value_)) return *value;
    mismatch("true or false");
}

double Json::number() const {
    if (const double* value = std::get_if<double>(&value_)) return *value;
    if (const std::int64_t* value = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*value);
    mismatch("a number");
}

std::int64_t Json::integer() const {
    if (const std::int64_t* value = std::get_if<std::int64_t>(&value_)) return *value;
    mismatch("an integer");
}

const std::string& Json::string() const {
    if (const std::string* value = std::get_if<std::string>(&value_)) return *value;
    mismatch("a string");
}

const Json::Array& Json::elements() const {
    if (const Array* values = std::get_if<Array>(&value_)) return *values;
    mismatch("an array");
}

const Json::Object& Json::members() const {
    if (const Object* members = std::get_if<Object>(&value_)) return *members;
    mismatch("an object");
}

std::size_t Json::size() const {
    if (is_array()) return elements().size();
    return is_object() ? members().size() : 0;
}

bool Json::has(std::string_view key) const {
    return is_object() && std::ranges::any_of(members(), [&](const Member& m) { return m.first == key; });
}

const Json& Json::operator[](std::string_view key) const {
    for (const auto& [name, value] : members()) {
        if (name == key) return value;
    }
    throw core::InputError("JSON", "", "there is no \"" + std::string(key) + "\"", "");
}

Json& Json::operator[](std::string_view key) {
    if (is_null()) value_ = Object();
    Object* members = std::get_if<Object>(&value_);
    if (members == nullptr) mismatch("an object");
    for (auto& [name, value] : *members) {
        if (name == key) return value;
    }
    return members->emplace_back(std::string(key), Json()).second;
}

const Json& Json::operator[](std::size_t index) const {
    if (index >= elements().size()) {
        throw core::InputError("JSON", "", "there is no element " + std::to_string(index), "");
    }
    return elements()[index];
}

Json& Json::operator[](std::size_t index) { return const_cast<Json&>(std::as_const(*this)[index]); }

void Json::push_back(Json value) {
    if (is_null()) value_ = Array();
    Array* values = std::get_if<Array>(&value_);
    if (values == nullptr) mismatch("an array");
    values->push_back(std::move(value));
}

std::string Json::dump(int indent, int digits) const {
    std::string text;
    append_to(text, indent, 0, digits);
    if (indent >= 0) text += '\n';
    return text;
}

void Json::append_to(std::string& text, int indent, int depth, int digits) const {
    if (is_null()) {
        text += "null";
    } else if (const bool* truth = std::get_if<bool>(&value_)) {
        text += *truth ? "true" : "false";
    } else if (const std::int64_t* whole = std::get_if<std::int64_t>(&value_)) {
        text += std::to_string(*whole);
    } else if (const double* real = std::get_if<double>(&value_)) {
        if (!std::isfinite(*real)) {
            text += "null";
        } else {
            const std::size_t begin = text.size();
            append_number(text, *real, digits);
            // A double stays a double when it is read back.
            if (text.find_first_of(".e", begin) == std::string::npos) text += ".0";
        }
    } else if (const std::string* string = std::get_if<std::string>(&value_)) {
        append_quoted(text, *string);
    } else if (const Array* values = std::get_if<Array>(&value_)) {
        const bool is_flat = std::ranges::all_of(*values, &Json::is_number);
        const int inner = is_flat ? -1 : indent;
        text += '[';
        for (std::size_t i = 0; i < values->size(); ++i) {
            if (i > 0) text += is_flat && indent >= 0 ? ", " : ",";
            new_line(text, inner, depth + 1);
            (*values)[i].append_to(text, indent, depth + 1, digits);
        }
        if (!values->empty()) new_line(text, inner, depth);
        text += ']';
    } else {
        const Object& members = std::get<Object>(value_);
        text += '{';
        for (std::size_t i = 0; i < members.size(); ++i) {
            if (i > 0) text += ',';
            new_line(text, indent, depth + 1);
            append_quoted(text, members[i].first);
            text += indent >= 0 ? ": " : ":";
            members[i].second.append_to(text, indent, depth + 1, digits);
        }
        if (!members.empty()) new_line(text, indent, depth);
        text += '}';
    }
}

}  // namespace dsc::io
