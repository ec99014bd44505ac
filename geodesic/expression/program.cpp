// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/expression/program.h"

#include <muParser.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "core/assert.h"
#include "core/pool.h"

namespace dsc::geodesic::expression {

namespace {

constexpr std::size_t longest_text = 16000;   // muParser reads at most 20000 characters at a time
constexpr std::size_t longest_operand = 500;  // longer operands get a temporary, so that statements stay short

/// Assignments in the order of evaluation, cut into pieces that muParser can read, and where the results are.
struct Listing {
    struct Output {
        double coefficient;
        int slot;  ///< of a temporary, or one of the three below
    };
    static constexpr int slot_one = 0, slot_u = 1, slot_v = 2, first_temporary = 3;

    std::vector<std::string> pieces;
    std::vector<Output> outputs;
    int slot_count = first_temporary;
};

std::string slot_name(int slot) {
    if (slot == Listing::slot_u) return "u";
    if (slot == Listing::slot_v) return "v";
    return std::string("t").append(std::to_string(slot));
}

std::string number(double value) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.17g", value);
    return text.data();
}

/// Writes the assignments. A node that is used once is written in place; the others get a temporary.
class Writer {
public:
    Writer(const Graph& graph, const std::vector<Multiple>& outputs) : graph_(graph), uses_(graph.size()) {
        slots_.assign(graph.size(), no_slot);
        slots_[Graph::one] = Listing::slot_one, slots_[Graph::u] = Listing::slot_u, slots_[Graph::v] = Listing::slot_v;
        for (const Multiple& output : outputs) count_uses(output.node);
        for (const Multiple& output : outputs) {
            if (slots_[output.node] == no_slot) assign(output.node, expression(output.node));
            listing_.outputs.push_back({output.coefficient, slots_[output.node]});
        }
    }
    Listing listing() && { return std::move(listing_); }

private:
    static constexpr int no_slot = -1;

    void count_uses(NodeId id) {
        if (++uses_[id] > 1) return;
        for (const Multiple& operand : graph_.node(id).operands) count_uses(operand.node);
    }

    void assign(NodeId id, const std::string& text) {
        slots_[id] = listing_.slot_count++;
        const std::string statement = slot_name(slots_[id]) + "=" + text;
        if (listing_.pieces.empty() || listing_.pieces.back().size() + statement.size() > longest_text)
            listing_.pieces.push_back(statement);
        else
            listing_.pieces.back() += "," + statement;
    }

    /// The text of a node as an operand: the name of its temporary, or its expression in parentheses.
    std::string operand(NodeId id) {
        if (slots_[id] == no_slot) {
            const std::string text = expression(id);
            if (uses_[id] == 1 && text.size() <= longest_operand)
                return graph_.node(id).operation == Operation::function ? text : "(" + text + ")";
            assign(id, text);
        }
        return slot_name(slots_[id]);
    }

    std::string expression(NodeId id) {
        const Node& node = graph_.node(id);
        const auto at = [&](std::size_t i) { return operand(node.operands[i].node); };
        switch (node.operation) {
            case Operation::sum: return sum(node);
            case Operation::product: {
                const std::string left = at(0);
                return left + "*" + at(1);
            }
            case Operation::reciprocal: return "1/" + at(0);
            case Operation::power: {
                const std::string base = at(0);
                return base + "^" + at(1);
            }
            case Operation::function: return function(node);
            case Operation::one:
            case Operation::variable_u:
            case Operation::variable_v: break;
        }
        return slot_name(slots_[id]);
    }

    std::string sum(const Node& node) {
        if (node.operands.empty()) return std::string("(").append(number(node.constant)).append(")");
        std::string text;
        for (const Multiple& term : node.operands) {
            append_sign(text, term.coefficient);
            if (std::abs(term.coefficient) != 1) text.append(number(std::abs(term.coefficient))).append("*");
            text += operand(term.node);
        }
        if (node.constant != 0) {
            append_sign(text, node.constant);
            text += number(std::abs(node.constant));
        }
        return text;
    }

    static void append_sign(std::string& text, double coefficient) {
        if (coefficient < 0)
            text += '-';
        else if (!text.empty())
            text += '+';
    }

    std::string function(const Node& node) {
        const std::string inner = operand(node.operands[0].node);
        // muParser's "log" is not the natural logarithm in every version.
        const std::string name = node.function == "log" ? "ln" : node.function;
        return name + (inner.front() == '(' ? inner : "(" + inner + ")");
    }

    const Graph& graph_;
    std::vector<int> uses_;
    std::vector<int> slots_;
    Listing listing_;
};

/// A listing in muParser's bytecode with variables of its own: for one thread at a time.
class Evaluator {
public:
    explicit Evaluator(const Listing& listing) : slots_(static_cast<std::size_t>(listing.slot_count)) {
        slots_[Listing::slot_one] = 1;
        parsers_.reserve(listing.pieces.size());
        for (const std::string& piece : listing.pieces) {
            mu::Parser& parser = parsers_.emplace_back();
            for (int slot = Listing::slot_u; slot < listing.slot_count; ++slot)
                parser.DefineVar(slot_name(slot), &slots_[static_cast<std::size_t>(slot)]);
            parser.SetExpr(piece);
        }
    }

    void evaluate(const Listing& listing, double u, double v, std::span<double> results) {
        slots_[Listing::slot_u] = u;
        slots_[Listing::slot_v] = v;
        int count = 0;
        for (const mu::Parser& parser : parsers_) parser.Eval(count);
        for (std::size_t i = 0; i < results.size(); ++i)
            results[i] = listing.outputs[i].coefficient * slots_[static_cast<std::size_t>(listing.outputs[i].slot)];
    }

private:
    std::vector<double> slots_;
    std::vector<mu::Parser> parsers_;
};

}  // namespace

struct Program::Compiled {
    explicit Compiled(Listing text)
        : listing(std::move(text)), evaluators([this] { return std::make_unique<Evaluator>(listing); }) {}

    const Listing listing;
    core::Pool<Evaluator> evaluators;
};

Program::Program(const Graph& graph, std::vector<Multiple> outputs)
    : compiled_(std::make_unique<Compiled>(Writer(graph, outputs).listing())) {}
Program::~Program() = default;

void Program::evaluate(double u, double v, std::span<double> results) const {
    DSC_ASSERT(results.size() == compiled_->listing.outputs.size());
    compiled_->evaluators.use([&](Evaluator& evaluator) { evaluator.evaluate(compiled_->listing, u, v, results); });
}

}  // namespace dsc::geodesic::expression
