// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_scanner.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "core/errors.h"
#include "core/random.h"
#include "io/number.h"
#include "tests/support/seed.h"

using dsc::core::InputError;
using dsc::io::in_quotes;
using dsc::io::TextScanner;

TEST_CASE("words and numbers come one after the other, without comments") {
    TextScanner scanner("f", "# head\n  name\t7 +2.5 # 1 2 3\r\n\n -3.0e0 end#", {.comment = '#'});
    CHECK(scanner.word("a name") == "name");
    CHECK(scanner.place() == "line 2");
    CHECK(scanner.integer("a count") == 7);
    CHECK_FALSE(scanner.at_line_end());
    CHECK(scanner.real("a number") == 2.5);
    CHECK(scanner.at_line_end());
    CHECK(scanner.whole_number("a label") == -3);
    CHECK(scanner.place() == "line 4");
    CHECK(scanner.word("the end") == "end");
    CHECK(scanner.at_end());
    CHECK_THROWS_WITH(scanner.word("more"), Catch::StartsWith("f: line 4: ends where more is expected; "));
}

TEST_CASE("without a comment sign there are no comments") {
    TextScanner scanner("f", "#1 #2");
    CHECK(scanner.word("a word") == "#1");
    CHECK(scanner.word("a word") == "#2");
}

TEST_CASE("every double is read exactly") {
    dsc::core::Random random(dsc::tests::seed(11));
    std::vector<double> values = {0.0, -0.0, 5e-324, 1.7976931348623157e308, 0.1};
    for (int i = 0; i < 1000; ++i) values.push_back(random.uniform(-1, 1) * std::pow(10, random.uniform(-300, 300)));
    std::string text;
    for (const double value : values) text += dsc::io::number_text(value) + "\n";
    TextScanner scanner("f", text);
    for (const double value : values) {
        const double read = scanner.real("a number");
        CHECK(std::memcmp(&read, &value, sizeof value) == 0);
    }
}

TEST_CASE("what is no number is refused with its line") {
    for (const char* word : {"x", "1x", "1.5.2", "nan", "inf", "-inf", "1e999", "+-1", "+", "-", "0x10", "1,5"}) {
        INFO(word);
        const std::string text = std::string("1\n") + word + " 2";
        TextScanner scanner("f", text);
        scanner.real("a number");
        CHECK_THROWS_WITH(scanner.real("a coordinate"),
                          "f: line 2: " + in_quotes(word) + " where a coordinate is expected; write a finite number");
    }
    for (const char* word : {"1.5", "1e3", "99999999999999999999", "x"}) {
        INFO(word);
        CHECK_THROWS_AS(TextScanner("f", word).integer("an index"), InputError);
    }
    CHECK_THROWS_AS(TextScanner("f", "1.5").whole_number("a label"), InputError);
    CHECK_THROWS_AS(TextScanner("f", "1e300").whole_number("a label"), InputError);
}

TEST_CASE("a count is not believed beyond the rest of the text") {
    CHECK(TextScanner("f", "2 1 1").count("rows", 2) == 2);
    for (const char* text : {"-1", "4 1 1", "4000000000000000000", "x", ""}) {
        INFO(text);
        CHECK_THROWS_AS(TextScanner("f", text).count("rows", 2), InputError);
    }
}

TEST_CASE("a record is one line") {
    const auto read = [](const char* text, bool is_whole) {
        TextScanner scanner("f", text, {.comment = '#'});
        scanner.begin_record("a row");
        scanner.integer("a number");
        scanner.integer("a number");
        is_whole ? scanner.end_record() : scanner.skip_record();
        return scanner.word("the next row") == "9";
    };
    CHECK(read("\n1 2 # rest\n9", true));
    CHECK(read("1 2 3 4\n9", false));
    CHECK_THROWS_WITH(read("1 2 3\n9", true), "f: line 1: there are more numbers than expected; remove them");
    for (const bool is_whole : {true, false}) {
        CHECK_THROWS_WITH(read("\n1\n2\n9", is_whole), Catch::StartsWith("f: line 2: there are fewer numbers"));
    }
}

TEST_CASE("bytes and lines are skipped, and a copy goes on alone") {
    TextScanner scanner("f", "title of the file\nab\n\n12 34 56");
    scanner.skip_line();
    CHECK(scanner.bytes(2) == "ab");
    TextScanner first = scanner;
    scanner.skip_words(2, "a number");
    first.end_at(scanner);
    CHECK(scanner.integer("a number") == 56);
    CHECK(first.integer("a number") == 12);
    CHECK(first.integer("a number") == 34);
    CHECK(first.place() == "line 4");
    CHECK(first.at_end());
    CHECK_THROWS_WITH(TextScanner("f", "1 2").require_end("rows"), Catch::Contains("more rows than announced"));
    CHECK(TextScanner("f", "1", {.within = "array"}).place() == "line 1 of array");
}

TEST_CASE("a word in a message is short and seen") {
    CHECK(in_quotes("abc") == "\"abc\"");
    CHECK(in_quotes("a\x01\xff\x7f") == "\"a???\"");
    CHECK(in_quotes(std::string(1000, 'x')).size() < 40);
}
