// SPDX-License-Identifier: GPL-3.0-or-later
// All partial derivatives up to order 3 of expressions in u and v, exact: differentiated symbolically by GiNaC with
// rational coefficients (decimal literals are exact fractions there).
// Guarantee: the same graph in every run; thread-safe (GiNaC is not: calls take turns).
// Cost: milliseconds for the usual surfaces; grows with the number of distinct subexpressions of the derivatives.
#pragma once

#include <array>
#include <vector>

#include "geodesic/expression/graph.h"
#include "geodesic/expression/syntax.h"

namespace dsc::geodesic::expression {

/// Derivatives of one function: value; u, v; uu, uv, vv; uuu, uuv, uvv, vvv.
using JetMultiples = std::array<Multiple, 10>;

/// Number of derivatives of order 0 to `order`.
constexpr std::size_t derivative_count(int order) { return static_cast<std::size_t>((order + 1) * (order + 2) / 2); }

struct JetGraph {
    Graph graph;
    std::vector<JetMultiples> components;
};

/// Throws core::InputError for expressions without a real, finite value anywhere: 1/0, log(-1), 9^9^9.
JetGraph differentiated(const SourceText& source, const std::vector<SyntaxTree>& trees);

}  // namespace dsc::geodesic::expression
