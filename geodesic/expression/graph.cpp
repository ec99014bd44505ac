// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/expression/graph.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dsc::geodesic::expression {

namespace {

/// One round of splitmix64: the same bits on every platform.
std::uint64_t mixed(std::uint64_t state, std::uint64_t value) {
    std::uint64_t z = state + 0x9E3779B97F4A7C15ULL + value;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
}

std::uint64_t mixed(std::uint64_t state, double value) { return mixed(state, std::bit_cast<std::uint64_t>(value)); }

double constant_function(const std::string& name, double x) {
    if (name == "sin") return std::sin(x);
    if (name == "cos") return std::cos(x);
    if (name == "tan") return std::tan(x);
    if (name == "asin") return std::asin(x);
    if (name == "acos") return std::acos(x);
    if (name == "atan") return std::atan(x);
    if (name == "sinh") return std::sinh(x);
    if (name == "cosh") return std::cosh(x);
    if (name == "tanh") return std::tanh(x);
    if (name == "exp") return std::exp(x);
    if (name == "log") return std::log(x);
    return std::sqrt(x);
}

bool is_same(const Node& a, const Node& b) {
    const auto is_same_operand = [](const Multiple& p, const Multiple& q) {
        return p.coefficient == q.coefficient && p.node == q.node;
    };
    return a.operation == b.operation && a.function == b.function && a.constant == b.constant &&
           std::equal(a.operands.begin(), a.operands.end(), b.operands.begin(), b.operands.end(), is_same_operand);
}

}  // namespace

Graph::Graph() {
    for (const Operation leaf : {Operation::one, Operation::variable_u, Operation::variable_v})
        insert({leaf, {}, 0, {}, 0});
}

NodeId Graph::insert(Node node) {
    node.hash = mixed(static_cast<std::uint64_t>(node.operation), node.constant);
    for (const char c : node.function) node.hash = mixed(node.hash, static_cast<std::uint64_t>(c));
    for (const Multiple& operand : node.operands)
        node.hash = mixed(mixed(node.hash, operand.coefficient), nodes_[operand.node].hash);
    const auto [first, last] = by_hash_.equal_range(node.hash);
    const auto same = std::find_if(first, last, [&](const auto& entry) { return is_same(nodes_[entry.second], node); });
    if (same != last) return same->second;
    const auto id = static_cast<NodeId>(nodes_.size());
    by_hash_.emplace(node.hash, id);
    nodes_.push_back(std::move(node));
    return id;
}

bool Graph::precedes(const Multiple& a, const Multiple& b) const {
    const std::uint64_t hash_a = nodes_[a.node].hash, hash_b = nodes_[b.node].hash;
    return hash_a != hash_b ? hash_a < hash_b : a.coefficient < b.coefficient;
}

/// A node equal to the multiple, for operations that take no coefficient.
NodeId Graph::materialized(const Multiple& multiple) {
    if (multiple.coefficient == 1) return multiple.node;
    if (multiple.node == one) return insert({Operation::sum, {}, multiple.coefficient, {}, 0});
    return insert({Operation::sum, {}, 0, {multiple}, 0});
}

Multiple Graph::sum(std::vector<Multiple> terms) {
    std::sort(terms.begin(), terms.end(), [&](const Multiple& a, const Multiple& b) { return precedes(a, b); });
    Node node{Operation::sum, {}, 0, {}, 0};
    for (const Multiple& term : terms) {
        if (term.node == one)
            node.constant += term.coefficient;
        else if (!node.operands.empty() && node.operands.back().node == term.node)
            node.operands.back().coefficient += term.coefficient;
        else
            node.operands.push_back(term);
    }
    std::erase_if(node.operands, [](const Multiple& term) { return term.coefficient == 0; });
    if (node.operands.empty()) return {node.constant, one};
    if (node.operands.size() == 1 && node.constant == 0) return node.operands.front();
    const double sign = node.operands.front().coefficient < 0 ? -1 : 1;
    for (Multiple& term : node.operands) term.coefficient *= sign;
    node.constant *= sign;
    if (node.constant == 0) node.constant = 0;  // -0 and 0 are one node
    return {sign, insert(std::move(node))};
}

NodeId Graph::product(NodeId a, NodeId b) {
    if (a == one) return b;
    if (b == one) return a;
    if (nodes_[b].hash < nodes_[a].hash) std::swap(a, b);
    return insert({Operation::product, {}, 0, {{1, a}, {1, b}}, 0});
}

Multiple Graph::product(std::vector<Multiple> factors) {
    std::sort(factors.begin(), factors.end(), [&](const Multiple& a, const Multiple& b) { return precedes(a, b); });
    Multiple result{1, one};
    for (const Multiple& factor : factors) {
        result.coefficient *= factor.coefficient;
        result.node = product(result.node, factor.node);
    }
    if (result.coefficient == 0) return {0, one};
    return result;
}

NodeId Graph::power_of_node(NodeId base, long exponent) {
    if (exponent == 1) return base;
    const NodeId half = power_of_node(base, exponent / 2);
    const NodeId square = product(half, half);
    return exponent % 2 == 0 ? square : product(square, base);
}

Multiple Graph::integer_power(const Multiple& base, long exponent) {
    if (exponent == 0) return {1, one};
    const double coefficient = std::pow(base.coefficient, static_cast<double>(exponent));
    if (base.node == one) return {coefficient, one};
    // Derivatives are full of 1/x, 1/x², 1/x³ of one x: one division serves them all.
    const NodeId node = exponent > 0 ? base.node : insert({Operation::reciprocal, {}, 0, {{1, base.node}}, 0});
    return {coefficient, power_of_node(node, std::abs(exponent))};
}

Multiple Graph::power(const Multiple& base, const Multiple& exponent) {
    if (base.node == one && exponent.node == one) return {std::pow(base.coefficient, exponent.coefficient), one};
    return {1, insert({Operation::power, {}, 0, {{1, materialized(base)}, {1, materialized(exponent)}}, 0})};
}

Multiple Graph::function(const std::string& name, const Multiple& operand) {
    if (operand.node == one) return {constant_function(name, operand.coefficient), one};
    return {1, insert({Operation::function, name, 0, {{1, materialized(operand)}}, 0})};
}

}  // namespace dsc::geodesic::expression
