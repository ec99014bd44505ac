// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_scanner.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "core/assert.h"
#include "core/errors.h"

namespace dsc::io {

namespace {

// Control characters count as blanks, so that no word can break a message into lines.
bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }

constexpr const char* truncated = "the file is truncated or a count is wrong";

}  // namespace

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 32;
    std::string text = "\"";
    for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > longest ? "…\"" : "\"");
}

TextScanner::TextScanner(std::string source, std::string_view text, Options options)
    : source_(std::move(source)), options_(std::move(options)), at_(text.data()), end_(text.data() + text.size()) {}

bool TextScanner::ends_word(const char* at) const {
    return at == end_ || is_blank(*at) || (*at == options_.comment && options_.comment != '\0');
}

void TextScanner::skip_to_line_end() {
    while (at_ != end_ && *at_ != '\n') ++at_;
}

void TextScanner::skip_blanks() {
    for (; at_ != end_; ++at_) {
        if (*at_ == '\n') {
            ++line_;
        } else if (!is_blank(*at_)) {
            if (*at_ != options_.comment) return;
            skip_to_line_end();
            if (at_ == end_) return;
            ++line_;
        }
    }
}

bool TextScanner::at_end() {
    skip_blanks();
    return at_ == end_;
}

bool TextScanner::at_line_end() {
    while (at_ != end_ && *at_ != '\n' && is_blank(*at_)) ++at_;
    return at_ == end_ || *at_ == '\n' || (*at_ == options_.comment && options_.comment != '\0');
}

void TextScanner::require_end(const char* things) {
    if (!at_end()) fail(std::string("there are more ") + things + " than announced", "correct their count");
}

void TextScanner::require_word(const char* expected) {
    skip_blanks();
    if (at_ == end_) fail(std::string("ends where ") + expected + " is expected", truncated);
}

std::string_view TextScanner::word(const char* expected) {
    require_word(expected);
    const char* first = at_;
    do {
        ++at_;
    } while (!ends_word(at_));
    return {first, static_cast<std::size_t>(at_ - first)};
}

double TextScanner::real(const char* expected) {
    require_word(expected);
    const char* first = at_;
    if (*first == '+' && first + 1 != end_ && first[1] != '-') ++first;
    double value = 0;
    const auto [last, error] = std::from_chars(first, end_, value);
    if (error != std::errc() || !ends_word(last) || !std::isfinite(value))
        reject_word(expected, "write a finite number");
    at_ = last;
    return value;
}

std::int64_t TextScanner::integer(const char* expected) {
    require_word(expected);
    const char* first = at_;
    if (*first == '+' && first + 1 != end_ && first[1] != '-') ++first;
    std::int64_t value = 0;
    const auto [last, error] = std::from_chars(first, end_, value);
    if (error != std::errc() || !ends_word(last)) reject_word(expected, "write a whole number");
    at_ = last;
    return value;
}

std::int64_t TextScanner::whole_number(const char* expected) {
    require_word(expected);
    const char* first = at_;
    const double value = real(expected);
    if (std::abs(value) > 0x1p53 || value != std::floor(value)) {
        at_ = first;
        reject_word(expected, "write a whole number");
    }
    return static_cast<std::int64_t>(value);
}

std::size_t TextScanner::count(const char* things, std::size_t least_bytes) {
    const std::int64_t value = integer((std::string("the number of ") + things).c_str());
    if (value < 0) fail(std::string("the number of ") + things + " is negative", "correct it");
    const auto count = static_cast<std::uint64_t>(value);
    const std::uint64_t room = rest().size() / least_bytes + 1;
    if (count > room || count >= std::numeric_limits<std::uint32_t>::max()) {
        fail(std::to_string(count) + " " + things + " are announced, more than the file has room for", truncated);
    }
    return count;
}

void TextScanner::skip_words(std::size_t count, const char* expected) {
    for (std::size_t i = 0; i < count; ++i) word(expected);
}

void TextScanner::skip_line() {
    skip_to_line_end();
    if (at_ == end_) return;
    ++at_;
    ++line_;
}

void TextScanner::begin_record(const char* expected) {
    require_word(expected);
    record_line_ = line_;
}

void TextScanner::require_one_line() const {
    if (line_ != record_line_) fail_at(record_line_, "there are fewer numbers than expected", "complete the line");
}

void TextScanner::end_record() {
    require_one_line();
    if (!at_line_end()) fail("there are more numbers than expected", "remove them");
}

void TextScanner::skip_record() {
    require_one_line();
    skip_to_line_end();
}

std::string_view TextScanner::bytes(std::size_t size) {
    DSC_ASSERT(size <= rest().size());
    const std::string_view taken = rest().substr(0, size);
    at_ += size;
    return taken;
}

std::string TextScanner::place() const {
    return "line " + std::to_string(line_) + (options_.within.empty() ? "" : " of " + options_.within);
}

void TextScanner::fail(const std::string& problem, const std::string& cure) const { fail_at(line_, problem, cure); }

void TextScanner::fail_at(std::size_t line, const std::string& problem, const std::string& cure) const {
    TextScanner there(*this);
    there.line_ = line;
    throw core::InputError(source_, there.place(), problem, cure);
}

void TextScanner::reject_word(const char* expected, const char* cure) {
    fail(in_quotes(word(expected)) + " where " + expected + " is expected", cure);
}

}  // namespace dsc::io
