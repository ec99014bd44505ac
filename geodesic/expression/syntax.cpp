// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/expression/syntax.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "core/errors.h"

namespace dsc::geodesic::expression {

namespace {

constexpr std::size_t deepest_nesting = 200;  // of parentheses and signs: bounds the recursion

struct Function {
    std::string_view name;
    std::size_t arguments;
};
constexpr std::array<Function, 13> functions{{{"sin", 1},
                                              {"cos", 1},
                                              {"tan", 1},
                                              {"asin", 1},
                                              {"acos", 1},
                                              {"atan", 1},
                                              {"sinh", 1},
                                              {"cosh", 1},
                                              {"tanh", 1},
                                              {"exp", 1},
                                              {"log", 1},
                                              {"sqrt", 1},
                                              {"pow", 2}}};
constexpr const char* known_names =
    "known are u, v, pi, e, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, sqrt, pow";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }  // UTF-8

std::string quoted(std::string_view text) { return std::string("'").append(text).append("'"); }

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i)
        list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return list;
}

/// Recursive descent over one component at a time.
class Parser {
public:
    explicit Parser(const SourceText& source) : source_(source), text_(source.text) {}

    bool at_end() {
        skip_space();
        return position_ == text_.size();
    }
    std::size_t position() const { return position_; }
    bool accept(char c) {
        if (at_end() || text_[position_] != c) return false;
        ++position_;
        return true;
    }
    std::string_view name() {
        skip_space();
        const std::size_t begin = position_;
        while (position_ < text_.size() &&
               (is_letter(text_[position_]) || (position_ > begin && is_digit(text_[position_]))))
            ++position_;
        return text_.substr(begin, position_ - begin);
    }
    std::string found() {
        if (at_end()) return "the end of the text";
        std::size_t end = position_ + 1;
        while (end < text_.size() && continues_character(text_[end])) ++end;
        return quoted(text_.substr(position_, end - position_));
    }

    SyntaxTree component(std::string name) {
        tree_ = {std::move(name), {}};
        if (at_end() || text_[position_] == ';')
            fail(position_, "the expression is empty", "write " + tree_.component + "=EXPRESSION");
        sum();
        if (!at_end() && text_[position_] != ';') fail_after_operand();
        return std::move(tree_);
    }

private:
    void skip_space() {
        while (position_ < text_.size() && is_space(text_[position_])) ++position_;
    }
    [[noreturn]] void fail(std::size_t offset, std::string problem, std::string cure) const {
        source_.fail(tree_.component, offset, std::move(problem), std::move(cure));
    }
    [[noreturn]] void fail_after_operand() {
        if (text_[position_] == ')') fail(position_, "this ')' has no '('", "remove it, or open a parenthesis");
        if (text_[position_] == '=') fail(position_, "unexpected '='", "separate the components by ';'");
        if (text_[position_] == ',')
            fail(position_, "unexpected ','", "only pow(BASE, EXPONENT) takes two arguments; decimals take a '.'");
        fail(position_, "expected an operator before " + found(), "write '*' between factors, and '^' for powers");
    }

    std::size_t add(SyntaxKind kind, std::size_t offset, std::vector<std::size_t> operands = {},
                    std::string text = {}) {
        tree_.nodes.push_back({kind, std::move(text), std::move(operands), offset});
        return tree_.nodes.size() - 1;
    }

    std::size_t sum() {
        std::size_t left = product();
        while (true) {
            skip_space();
            const std::size_t offset = position_;
            if (accept('+'))
                left = add(SyntaxKind::add, offset, {left, product()});
            else if (accept('-'))
                left = add(SyntaxKind::subtract, offset, {left, product()});
            else
                return left;
        }
    }

    std::size_t product() {
        std::size_t left = signed_power();
        while (true) {
            skip_space();
            const std::size_t offset = position_;
            if (accept('*'))
                left = add(SyntaxKind::multiply, offset, {left, signed_power()});
            else if (accept('/'))
                left = add(SyntaxKind::divide, offset, {left, signed_power()});
            else
                return left;
        }
    }

    std::size_t signed_power() {
        skip_space();
        const std::size_t offset = position_;
        if (++depth_ > deepest_nesting) fail(offset, "the expression is nested too deeply", "simplify it");
        std::size_t result;
        if (accept('-'))
            result = add(SyntaxKind::negate, offset, {signed_power()});
        else if (accept('+'))
            result = signed_power();
        else
            result = power();
        --depth_;
        return result;
    }

    std::size_t power() {
        const std::size_t base = primary();
        skip_space();
        const std::size_t offset = position_;
        if (!accept('^')) return base;
        return add(SyntaxKind::power, offset, {base, signed_power()});
    }

    std::size_t primary() {
        skip_space();
        const std::size_t offset = position_;
        if (accept('(')) {
            const std::size_t inner = sum();
            close(offset);
            return inner;
        }
        if (!at_end() && (is_digit(text_[offset]) || text_[offset] == '.')) return number();
        if (!at_end() && is_letter(text_[offset])) return named();
        const bool is_repeated_sign = !at_end() && offset > 0 && text_[offset] == '*' && text_[offset - 1] == '*';
        fail(offset, "expected a number, a name or '(' but found " + found(),
             is_repeated_sign ? "write '^' for powers" : "complete the expression");
    }

    void close(std::size_t opened) {
        if (accept(')')) return;
        if (at_end() || text_[position_] == ';') fail(opened, "this '(' has no ')'", "close the parenthesis");
        fail_after_operand();
    }

    std::size_t number() {
        const std::size_t begin = position_;
        while (position_ < text_.size() && (is_digit(text_[position_]) || text_[position_] == '.')) ++position_;
        if (position_ < text_.size() && (text_[position_] == 'e' || text_[position_] == 'E')) {
            std::size_t exponent = position_ + 1;
            if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
            if (exponent < text_.size() && is_digit(text_[exponent])) {
                position_ = exponent;
                while (position_ < text_.size() && is_digit(text_[position_])) ++position_;
            }
        }
        const std::string_view literal = text_.substr(begin, position_ - begin);
        double value = 0;
        const auto [end, error] = std::from_chars(literal.data(), literal.data() + literal.size(), value);
        if (error == std::errc::result_out_of_range)
            fail(begin, "the number " + std::string(literal) + " is out of range", "use numbers from 1e-300 to 1e300");
        if (error != std::errc() || end != literal.data() + literal.size())
            fail(begin, quoted(literal) + " is not a number", "write e.g. 1.5 or 2e-3");
        return add(SyntaxKind::number, begin, {}, std::string(literal));
    }

    std::size_t named() {
        const std::size_t offset = position_;
        const std::string_view word = name();
        if (word == "u") return add(SyntaxKind::variable_u, offset);
        if (word == "v") return add(SyntaxKind::variable_v, offset);
        if (word == "pi") return add(SyntaxKind::pi, offset);
        if (word == "e") return add(SyntaxKind::e, offset);
        const auto* function =
            std::find_if(functions.begin(), functions.end(), [&](const Function& f) { return f.name == word; });
        if (function == functions.end()) fail(offset, "unknown name " + quoted(word), known_names);
        return call(*function, offset);
    }

    std::size_t call(const Function& function, std::size_t offset) {
        const std::string name(function.name);
        const std::string usage = function.arguments == 2 ? name + "(BASE, EXPONENT)" : name + "(ARGUMENT)";
        skip_space();
        const std::size_t opened = position_;
        if (!accept('(')) fail(offset, "the function " + quoted(name) + " has no argument", "write " + usage);
        std::vector<std::size_t> arguments;
        do {
            if (!at_end() && text_[position_] == ')')
                fail(position_, "an argument of " + quoted(name) + " is missing", "write " + usage);
            skip_space();
            const std::size_t begin = position_;
            arguments.push_back(sum());
            if (arguments.size() > function.arguments)
                fail(begin, "too many arguments for " + quoted(name), "write " + usage + "; decimals take a '.'");
        } while (accept(','));
        close(opened);
        if (arguments.size() < function.arguments)
            fail(position_ - 1, "an argument of " + quoted(name) + " is missing", "write " + usage);
        return add(SyntaxKind::function, offset, std::move(arguments), name);
    }

    SourceText source_;
    std::string_view text_;
    std::size_t position_ = 0;
    std::size_t depth_ = 0;
    SyntaxTree tree_;
};

}  // namespace

void SourceText::fail(std::string_view component, std::size_t offset, std::string problem, std::string cure) const {
    const auto before = text.substr(0, offset);
    const auto column = 1 + std::count_if(before.begin(), before.end(), [](char c) { return !continues_character(c); });
    std::string place = component.empty() ? "" : std::string(component) + ", ";
    place += "column " + std::to_string(column);
    throw core::InputError(std::string(source), std::move(place), std::move(problem), std::move(cure));
}

std::vector<SyntaxTree> parse_components(const SourceText& source, const std::vector<std::string>& components) {
    const std::string wanted = "give " + listed(components) + ", separated by ';'";
    std::vector<std::optional<SyntaxTree>> found(components.size());
    Parser parser(source);
    while (!parser.at_end()) {
        const std::string name(parser.name());
        const std::size_t offset = parser.position() - name.size();
        if (name.empty())
            source.fail("", offset, "expected the name of a component but found " + parser.found(), wanted);
        const auto index =
            static_cast<std::size_t>(std::find(components.begin(), components.end(), name) - components.begin());
        if (index == components.size()) source.fail("", offset, "unknown component " + quoted(name), wanted);
        if (found[index]) source.fail(name, offset, "component " + quoted(name) + " is given twice", wanted);
        if (!parser.accept('='))
            source.fail(name, parser.position(), "expected '=' but found " + parser.found(), wanted);
        found[index] = parser.component(name);
        parser.accept(';');
    }
    std::vector<SyntaxTree> trees;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (!found[i])
            source.fail("", source.text.size(), "component " + quoted(components[i]) + " is missing", wanted);
        trees.push_back(std::move(*found[i]));
    }
    return trees;
}

}  // namespace dsc::geodesic::expression
