// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/xml.h"

#include <cctype>
#include <stdexcept>

namespace dsc::tests {

namespace {

class Parser {
public:
    explicit Parser(const std::string& text) : text_(text) {}

    XmlElement document() {
        if (text_.rfind("<?xml", 0) == 0) at_ = text_.find("?>") + 2;
        skip_space();
        XmlElement root = element();
        skip_space();
        if (at_ != text_.size()) fail("something after the root");
        return root;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error("XML at byte " + std::to_string(at_) + ": " + what);
    }
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip_space() {
        while (std::isspace(static_cast<unsigned char>(peek()))) ++at_;
    }
    void expect(const std::string& what) {
        if (text_.compare(at_, what.size(), what) != 0) fail("expected " + what);
        at_ += what.size();
    }
    std::string name() {
        const std::size_t begin = at_;
        while (std::isalnum(static_cast<unsigned char>(peek())) || peek() == '-' || peek() == '_' || peek() == ':')
            ++at_;
        if (begin == at_) fail("expected a name");
        return text_.substr(begin, at_ - begin);
    }
    // Text up to `end`, with its entities resolved.
    std::string text_until(char end) {
        static const std::map<std::string, char> entities{
            {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"#39", '\''}};
        std::string result;
        while (peek() != end) {
            if (at_ >= text_.size() || peek() == '<') fail("text is not ended");
            if (peek() == '&') {
                const std::size_t semicolon = text_.find(';', at_);
                const auto entity = entities.find(text_.substr(at_ + 1, semicolon - at_ - 1));
                if (entity == entities.end()) fail("unknown entity");
                result += entity->second;
                at_ = semicolon + 1;
            } else {
                result += text_[at_++];
            }
        }
        return result;
    }
    XmlElement element() {
        expect("<");
        XmlElement result;
        result.name = name();
        for (skip_space(); peek() != '>' && peek() != '/'; skip_space()) {
            const std::string key = name();
            expect("=\"");
            if (!result.attributes.emplace(key, text_until('"')).second) fail("attribute given twice");
            expect("\"");
        }
        if (peek() == '/') {
            expect("/>");
            return result;
        }
        expect(">");
        while (text_.compare(at_, 2, "</") != 0) {
            if (peek() == '<') {
                result.children.push_back(element());
            } else {
                result.text += text_until('<');
            }
        }
        expect("</" + result.name + ">");
        return result;
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

void collect(const XmlElement& element, const std::string& wanted, std::vector<const XmlElement*>& found) {
    for (const XmlElement& child : element.children) {
        if (child.name == wanted) found.push_back(&child);
        collect(child, wanted, found);
    }
}

}  // namespace

std::vector<const XmlElement*> XmlElement::all(const std::string& wanted) const {
    std::vector<const XmlElement*> found;
    collect(*this, wanted, found);
    return found;
}

XmlElement parse_xml(const std::string& text) { return Parser(text).document(); }

}  // namespace dsc::tests
