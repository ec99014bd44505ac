// SPDX-License-Identifier: GPL-3.0-or-later
// Words and numbers of a text, one after the other, for the readers of text files.
// Guarantee: what is wrong throws core::InputError with the source, the line and the cure, in one line whatever the
// text contains. Numbers are finite, read independently of the locale and exactly (the nearest double). Nothing is
// allocated but for a message. Cost: one pass over the text, some 30 ns per number.
//
//     io::TextScanner scanner("house.node", text, {.comment = '#'});
//     const std::size_t count = scanner.count("vertices", 8);
//     const double x = scanner.real("a coordinate");
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace dsc::io {

class TextScanner {
public:
    struct Options {
        char comment = '\0';  ///< from this character to the end of the line the text is skipped; '\0': no comments
        std::string within;   ///< what the lines are counted in, when it is not the whole file
    };

    /// `text` has to outlive the scanner. A copy goes on from the same place, independently.
    TextScanner(std::string source, std::string_view text, Options options);
    TextScanner(std::string source, std::string_view text) : TextScanner(std::move(source), text, Options{}) {}

    /// Whether only blanks and comments are left: in all, or in the line of the last word.
    bool at_end();
    bool at_line_end();
    /// Throws when there is more, `things` beyond their count.
    void require_end(const char* things);

    /// The next word; `expected` says in a message what is missing.
    std::string_view word(const char* expected);
    double real(const char* expected);
    std::int64_t integer(const char* expected);
    /// An integer written in any way ("3", "3.0", "3e0").
    std::int64_t whole_number(const char* expected);
    /// How many `things` follow. Not more than the rest of the text has room for, `least_bytes` for each with the blank
    /// after it: memory can be reserved for so many.
    std::size_t count(const char* things, std::size_t least_bytes);

    void skip_words(std::size_t count, const char* expected);
    /// To the beginning of the next line.
    void skip_line();

    /// A record is what has to stand on one line: from the next word up to end_record(), which rejects what goes over
    /// several lines or leaves something; skip_record() leaves the rest of the line unread.
    void begin_record(const char* expected);
    void end_record();
    void skip_record();

    /// What is left, from the end of the last word.
    std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }
    /// The next `size` bytes, not looked at; there have to be so many.
    std::string_view bytes(std::size_t size);

    /// Lets the text end where `other`, a copy that has gone on, stands.
    void end_at(const TextScanner& other) { end_ = other.at_; }

    const std::string& source() const { return source_; }
    /// The place of the last word: "line 7".
    std::string place() const;
    [[noreturn]] void fail(const std::string& problem, const std::string& cure) const;

private:
    bool ends_word(const char* at) const;
    void skip_blanks();
    void skip_to_line_end();
    void require_word(const char* expected);
    void require_one_line() const;
    [[noreturn]] void reject_word(const char* expected, const char* cure);
    [[noreturn]] void fail_at(std::size_t line, const std::string& problem, const std::string& cure) const;

    std::string source_;
    Options options_;
    const char* at_;
    const char* end_;
    std::size_t line_ = 1;
    std::size_t record_line_ = 1;
};

/// `word` in quotes for a message: shortened, without characters that are not seen.
std::string in_quotes(std::string_view word);

}  // namespace dsc::io
