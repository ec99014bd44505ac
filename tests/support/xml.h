// SPDX-License-Identifier: GPL-3.0-or-later
// Just enough of XML to read back what the writers wrote, and to see that it is well-formed.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace dsc::tests {

struct XmlElement {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;  ///< what stands directly in it
    std::vector<XmlElement> children;

    /// All elements below with this name, in document order.
    std::vector<const XmlElement*> all(const std::string& wanted) const;
};

/// The root element; throws std::runtime_error when the text is not well-formed.
XmlElement parse_xml(const std::string& text);

}  // namespace dsc::tests
