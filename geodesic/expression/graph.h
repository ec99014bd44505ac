// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic expressions as a graph in which equal subexpressions exist once: the form between symbolic derivatives
// and a program that evaluates them.
// Guarantee: a graph depends on the mathematics put in and on nothing else: operands of sums and products are put in
// the order of a hash of their content and leading signs are normalized, so that the order in which a computer algebra
// system happens to hold them (GiNaC's follows memory addresses) does not reach the bits of a result.
// Cost: constant per operand, up to a sort.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace dsc::geodesic::expression {

using NodeId = std::uint32_t;

enum class Operation {
    one,  ///< 1: what a constant is a multiple of
    variable_u,
    variable_v,
    sum,         ///< constant + Σ coefficient · operand
    product,     ///< of two operands
    reciprocal,  ///< 1 / operand
    power,       ///< operand ^ operand
    function     ///< of one operand, by its name in the grammar
};

/// coefficient · node.
struct Multiple {
    double coefficient = 0;
    NodeId node = 0;
};

struct Node {
    Operation operation;
    std::string function;            ///< its name if operation == function
    double constant = 0;             ///< of a sum
    std::vector<Multiple> operands;  ///< coefficients differ from 1 in sums only
    std::uint64_t hash = 0;          ///< of the content: the same in every run
};

class Graph {
public:
    static constexpr NodeId one = 0, u = 1, v = 2;

    Graph();

    /// Each returns the canonical form of its expression; constants are folded.
    Multiple sum(std::vector<Multiple> terms);
    Multiple product(std::vector<Multiple> factors);
    Multiple power(const Multiple& base, const Multiple& exponent);
    Multiple integer_power(const Multiple& base, long exponent);
    Multiple function(const std::string& name, const Multiple& operand);

    const Node& node(NodeId id) const { return nodes_[id]; }
    std::size_t size() const { return nodes_.size(); }

private:
    NodeId insert(Node node);
    NodeId materialized(const Multiple& multiple);
    NodeId product(NodeId a, NodeId b);
    NodeId power_of_node(NodeId base, long exponent);
    bool precedes(const Multiple& a, const Multiple& b) const;

    std::vector<Node> nodes_;
    std::unordered_multimap<std::uint64_t, NodeId> by_hash_;
};

}  // namespace dsc::geodesic::expression
