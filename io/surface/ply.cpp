// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/ply.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/errors.h"
#include "io/surface/bytes.h"

namespace dsc::io::surface {

namespace {

using tet::NumberType;

constexpr const char* truncated = "the file is truncated or a count is wrong";

struct TypeName {
    std::string_view original;
    std::string_view by_width;
    NumberType type;
};

constexpr TypeName type_names[] = {
    {"char", "int8", NumberType::int8},        {"uchar", "uint8", NumberType::uint8},
    {"short", "int16", NumberType::int16},     {"ushort", "uint16", NumberType::uint16},
    {"int", "int32", NumberType::int32},       {"uint", "uint32", NumberType::uint32},
    {"long", "int64", NumberType::int64},      {"ulong", "uint64", NumberType::uint64},
    {"float", "float32", NumberType::float32}, {"double", "float64", NumberType::float64}};

NumberType read_type(TextScanner& scanner) {
    const std::string_view word = scanner.word("the type of a property");
    for (const TypeName& name : type_names) {
        if (word == name.original || word == name.by_width) return name.type;
    }
    scanner.fail(in_quotes(word) + " where the type of a property is expected",
                 "use char, uchar, short, ushort, int, uint, float or double");
}

bool is_real(NumberType type) { return type == NumberType::float32 || type == NumberType::float64; }

// A line for each row.
class TextBody : public PlyBody {
public:
    explicit TextBody(TextScanner scanner) : scanner_(std::move(scanner)) {}

    void begin_row(const PlyElement& element, std::uint64_t /*row*/) override {
        scanner_.begin_record(element.name.c_str());
    }
    double number(NumberType type) override {
        return is_real(type) ? scanner_.real("a number") : static_cast<double>(scanner_.whole_number("a whole number"));
    }
    void skip(NumberType /*type*/, std::uint64_t count) override { scanner_.skip_words(count, "a number"); }
    void end_row() override { scanner_.end_record(); }
    void require_end() override { scanner_.require_end("rows"); }

    std::uint64_t room(const PlyElement& element) const override {
        return scanner_.rest().size() / (2 * element.properties.size()) + 1;
    }
    void fail(const std::string& problem, const std::string& cure) const override { scanner_.fail(problem, cure); }

private:
    TextScanner scanner_;
};

class BinaryBody : public PlyBody {
public:
    BinaryBody(std::string source, std::string_view rest, std::endian order)
        : source_(std::move(source)), rest_(rest), order_(order) {}

    void begin_row(const PlyElement& element, std::uint64_t row) override {
        element_ = &element;
        row_ = row;
    }
    double number(NumberType type) override {
        const char* at = take(tet::size_of(type), 1);
        switch (type) {
            case NumberType::int8: return number_at<std::int8_t>(at, order_);
            case NumberType::uint8: return number_at<std::uint8_t>(at, order_);
            case NumberType::int16: return number_at<std::int16_t>(at, order_);
            case NumberType::uint16: return number_at<std::uint16_t>(at, order_);
            case NumberType::int32: return number_at<std::int32_t>(at, order_);
            case NumberType::uint32: return number_at<std::uint32_t>(at, order_);
            case NumberType::int64: return static_cast<double>(number_at<std::int64_t>(at, order_));
            case NumberType::uint64: return static_cast<double>(number_at<std::uint64_t>(at, order_));
            case NumberType::float32: return static_cast<double>(number_at<float>(at, order_));
            default: return number_at<double>(at, order_);
        }
    }
    void skip(NumberType type, std::uint64_t count) override { take(tet::size_of(type), count); }
    void end_row() override {}
    void require_end() override {
        if (!rest_.empty()) fail("there are more bytes behind this row than announced", "correct the counts");
    }

    std::uint64_t room(const PlyElement& element) const override {
        std::uint64_t least_bytes = 0;
        for (const PlyProperty& property : element.properties) {
            least_bytes += tet::size_of(property.count_type.value_or(property.type));
        }
        return rest_.size() / least_bytes;
    }
    void fail(const std::string& problem, const std::string& cure) const override {
        const std::string place =
            element_ == nullptr ? "" : "row " + std::to_string(row_) + " of " + in_quotes(element_->name);
        throw core::InputError(source_, place, problem, cure);
    }

private:
    const char* take(std::size_t size, std::uint64_t count) {
        if (count > rest_.size() / size) fail("ends within this row", truncated);
        const char* at = rest_.data();
        rest_.remove_prefix(size * count);
        return at;
    }

    std::string source_;
    std::string_view rest_;
    std::endian order_;
    const PlyElement* element_ = nullptr;
    std::uint64_t row_ = 0;
};

}  // namespace

bool PlyElement::has(std::string_view property) const {
    return std::ranges::any_of(properties, [&](const PlyProperty& p) { return !p.count_type && p.name == property; });
}

bool PlyElement::has_list(std::string_view property) const {
    return std::ranges::any_of(properties, [&](const PlyProperty& p) { return p.count_type && p.name == property; });
}

std::int64_t PlyBody::whole(NumberType type, const char* what) {
    const double value = number(type);
    if (!is_whole(value)) fail(std::string(what) + " is not a whole number", "correct it");
    return static_cast<std::int64_t>(value);
}

double PlyBody::finite(NumberType type, const char* what) {
    const double value = number(type);
    if (!std::isfinite(value)) fail(std::string(what) + " is not a finite number", "correct it");
    return value;
}

PlyReader::PlyReader(const std::string& source, std::string_view bytes) {
    TextScanner scanner(source, bytes);
    read_head(scanner);
    if (encoding_ == "ascii") {
        body_ = std::make_unique<TextBody>(std::move(scanner));
    } else {
        const std::endian order = encoding_ == "binary_big_endian" ? std::endian::big : std::endian::little;
        body_ = std::make_unique<BinaryBody>(source, scanner.rest(), order);
    }
}

void PlyReader::read_head(TextScanner& scanner) {
    if (scanner.word("ply") != "ply") scanner.fail("is no PLY file: it does not begin with ply", "save it as PLY");
    for (std::string_view word = scanner.word("a line of the head"); word != "end_header";
         word = scanner.word("a line of the head")) {
        if (word == "format") {
            encoding_ = scanner.word("the format");
        } else if (word == "element") {
            read_element(scanner);
        } else if (word == "property") {
            read_property(scanner);
        } else if (word != "comment" && word != "obj_info") {
            scanner.fail(in_quotes(word) + " where a line of the head is expected", "correct or remove the line");
        }
        scanner.skip_line();
    }
    if (encoding_ != "ascii" && encoding_ != "binary_little_endian" && encoding_ != "binary_big_endian") {
        scanner.fail("the format is " + in_quotes(encoding_), "use ascii, binary_little_endian or binary_big_endian");
    }
    scanner.skip_line();
}

void PlyReader::read_element(TextScanner& scanner) {
    const std::string name(scanner.word("the name of an element"));
    if (std::ranges::find(elements_, name, &PlyElement::name) != elements_.end()) {
        scanner.fail("there is a second element " + in_quotes(name), "join the two");
    }
    const std::int64_t count = scanner.integer("the number of rows");
    if (count < 0) scanner.fail("the number of rows is negative", "correct it");
    elements_.push_back({.name = name, .count = static_cast<std::uint64_t>(count), .properties = {}});
}

void PlyReader::read_property(TextScanner& scanner) {
    if (elements_.empty()) scanner.fail("there is a property before all elements", "put the element first");
    PlyProperty& property = elements_.back().properties.emplace_back();
    TextScanner ahead = scanner;
    if (ahead.word("the type of a property") == "list") {
        scanner = ahead;
        property.count_type = read_type(scanner);
        if (is_real(*property.count_type)) scanner.fail("a list is counted by real numbers", "use uchar or int");
    }
    property.type = read_type(scanner);
    property.name = scanner.word("the name of a property");
}

void PlyReader::require_room(const PlyElement& element) const {
    if (element.count == 0) return;
    if (element.properties.empty())
        body_->fail("the element " + in_quotes(element.name) + " has no properties", "remove it");
    if (element.count > body_->room(element) || element.count >= std::numeric_limits<std::uint32_t>::max()) {
        body_->fail(std::to_string(element.count) + " rows of " + in_quotes(element.name) +
                        " are announced, more than the file has room for",
                    truncated);
    }
}

void PlyReader::skip_rows(const PlyElement& element) {
    require_room(element);
    PlyRows rows(element, {});
    for (std::uint64_t i = 0; i < element.count; ++i) rows.read(*body_);
}

PlyRows::PlyRows(const PlyElement& element, std::span<const std::string_view> numbers, std::string_view list)
    : element_(element), numbers_(numbers.size()) {
    for (const PlyProperty& property : element.properties) {
        Step& step = steps_.emplace_back(Step{.property = &property, .slot = {}});
        const auto wanted = std::ranges::find(numbers, property.name);
        if (property.count_type) {
            step.is_wanted_list = property.name == list;
        } else if (wanted != numbers.end()) {
            step.slot = static_cast<std::size_t>(wanted - numbers.begin());
        }
    }
}

void PlyRows::read(PlyBody& body) {
    body.begin_row(element_, row_++);
    for (const Step& step : steps_) {
        if (step.property->count_type) {
            read_list(body, *step.property, step.is_wanted_list);
        } else if (step.slot) {
            numbers_[*step.slot] = body.finite(step.property->type, step.property->name.c_str());
        } else {
            body.skip(step.property->type, 1);
        }
    }
    body.end_row();
}

void PlyRows::read_list(PlyBody& body, const PlyProperty& property, bool is_wanted) {
    const std::int64_t count = body.whole(*property.count_type, "the length of a list");
    if (count < 0) body.fail("the length of a list is negative", "correct it");
    if (!is_wanted) {
        body.skip(property.type, static_cast<std::uint64_t>(count));
        return;
    }
    list_.clear();
    for (std::int64_t i = 0; i < count; ++i) list_.push_back(body.whole(property.type, "the number of a vertex"));
}

}  // namespace dsc::io::surface
