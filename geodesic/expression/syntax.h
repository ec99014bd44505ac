// SPDX-License-Identifier: GPL-3.0-or-later
// The grammar of the expressions on a command line, "x=(2+cos(v))*cos(u); y=...": read into syntax trees in which every
// node knows its column, so that any later complaint can point at its cause.
//
//   components = component { ";" component } [ ";" ]        component = name "=" sum
//   sum        = product { ("+" | "-") product }            product   = signed { ("*" | "/") signed }
//   signed     = ("+" | "-") signed | power                 power     = primary [ "^" signed ]
//   primary    = number | "u" | "v" | "pi" | "e" | function "(" sum { "," sum } ")" | "(" sum ")"
//
// "^" binds to the right and tighter than a sign: -u^2 = -(u^2), 2^3^2 = 2^9, 2^-1 = 1/2.
// Cost: linear in the length of the text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dsc::geodesic::expression {

enum class SyntaxKind {
    number,
    variable_u,
    variable_v,
    pi,
    e,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    function
};

struct SyntaxNode {
    SyntaxKind kind;
    std::string text;                   ///< the literal of a number, the name of a function
    std::vector<std::size_t> operands;  ///< nodes of the same tree
    std::size_t offset;                 ///< place in the text, in bytes: of the operator, the name or the number
};

/// The tree of one component; its root is the last node, and operands precede their operators.
struct SyntaxTree {
    std::string component;
    std::vector<SyntaxNode> nodes;

    const SyntaxNode& root() const { return nodes.back(); }
};

/// The text of an option with the option's name, for messages.
struct SourceText {
    std::string_view source;
    std::string_view text;

    /// Throws core::InputError: "SOURCE: COMPONENT, column N: PROBLEM; CURE". Columns count characters from 1.
    [[noreturn]] void fail(std::string_view component, std::size_t offset, std::string problem, std::string cure) const;
};

/// Reads one expression for each of `components`, which may come in any order; the result is in the order asked for.
/// Throws core::InputError for anything outside the grammar, and for components that are missing, repeated or unknown.
std::vector<SyntaxTree> parse_components(const SourceText& source, const std::vector<std::string>& components);

}  // namespace dsc::geodesic::expression
