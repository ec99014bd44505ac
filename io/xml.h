// SPDX-License-Identifier: GPL-3.0-or-later
// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace dsc::io {

/// `text` with the characters that mean something in XML escaped, for elements and quoted attributes; control
/// characters that XML has no way to write are left out.
std::string xml_escaped(std::string_view text);

}  // namespace dsc::io
