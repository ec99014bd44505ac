// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates a set of expressions of a graph at once, every common subexpression a single time: one muParser program of
// assignments to temporaries ("t0=cos(u),t1=2+t0,...").
// Guarantee: evaluate() is thread-safe and deterministic; no allocation, once each of the threads that call at the same
// time has had its evaluator. Cost: about 3 ns per operation and 10 to 20 ns per function.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geodesic/expression/graph.h"

namespace dsc::geodesic::expression {

class Program {
public:
    Program(const Graph& graph, std::vector<Multiple> outputs);
    ~Program();

    /// Precondition: results.size() is the number of outputs.
    void evaluate(double u, double v, std::span<double> results) const;

private:
    struct Compiled;
    std::unique_ptr<Compiled> compiled_;
};

}  // namespace dsc::geodesic::expression
