// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as text, independent of the locale.
// Guarantee: with 17 digits (the default) the text is the shortest that reads back as the same double.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dsc::io {

/// Appends `value` with at most `digits` significant digits; "nan", "inf" and "-inf" for what is not finite.
void append_number(std::string& text, double value, int digits = 17);

std::string number_text(double value, int digits = 17);

/// The number that all of `text` stands for (a leading '+' is allowed); empty if it is none or not finite.
std::optional<double> parse_finite(std::string_view text);

}  // namespace dsc::io
