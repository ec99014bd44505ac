// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/number.h"

#include <charconv>
#include <cmath>

namespace dsc::io {

void append_number(std::string& text, double value, int digits) {
    char buffer[40];
    const auto result = digits >= 17
                            ? std::to_chars(buffer, buffer + sizeof buffer, value)
                            : std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits);
    text.append(buffer, result.ptr);
}

std::string number_text(double value, int digits) {
    std::string text;
    append_number(text, value, digits);
    return text;
}

std::optional<double> parse_finite(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

}  // namespace dsc::io
