// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/progress.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

using namespace dsc::apps;

namespace {

// What is printed to a stream that is no terminal while `talk` runs.
template <class Talk>
std::string printed(ProgressMode mode, Talk&& talk) {
    std::FILE* stream = std::tmpfile();
    {
        ProgressObserver observer(mode, stream);
        talk(observer);
    }
    std::string text(static_cast<std::size_t>(std::ftell(stream)), '\0');
    std::rewind(stream);
    text.resize(std::fread(text.data(), 1, text.size(), stream));
    std::fclose(stream);
    return text;
}

}  // namespace

TEST_CASE("progress says nothing where there is no terminal") {
    const auto talk = [](ProgressObserver& observer) { observer.progress("stage", 0.5, "figure"); };
    CHECK(printed(ProgressMode::automatic, talk).empty());
    CHECK(printed(ProgressMode::none, talk).empty());
}

TEST_CASE("progress is one line, rewritten at most ten times a second and cleared at the end") {
    const std::string text = printed(ProgressMode::bar, [](ProgressObserver& observer) {
        for (int i = 0; i < 1000; ++i) observer.progress("stage", 0.5, "figure");
    });
    CHECK(text.find('\n') == std::string::npos);
    CHECK(std::ranges::count(text, '\r') <= 5);
    CHECK(text.rfind("\rstage 50 %, figure", 0) == 0);
    CHECK(text.substr(text.size() - 4) == "\r\x1b[K");
}

TEST_CASE("a long line is cut to the width of the terminal, not within a character") {
    const std::string text = printed(ProgressMode::bar, [](ProgressObserver& observer) {
        std::string figure;
        for (int i = 0; i < 200; ++i) figure += "\u03bb";
        observer.progress("x", -1, figure);
    });
    const std::string line = text.substr(1, text.find('\x1b') - 1);
    const auto characters =
        std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    CHECK(characters == 79);
    CHECK(line.substr(line.size() - 2) == "\u03bb");
}
