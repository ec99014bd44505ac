// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/expression/derivatives.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <unordered_map>

#include "core/errors.h"

#ifdef __SANITIZE_ADDRESS__
// CLN, under GiNaC, leaves 26 bytes of its start-up tables behind in every program that is linked with it.
extern "C" const char* __lsan_default_suppressions() { return "leak:libcln"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace dsc::geodesic::expression {

namespace {

constexpr int largest_exponent = 1000;  // exact powers of constants beyond it would exhaust the memory

std::mutex ginac_turn;  // GiNaC's reference counts and tables are shared by all expressions

/// A decimal literal as the exact fraction it denotes.
GiNaC::numeric exact_number(const std::string& literal) {
    if (std::stod(literal) == 0) return 0;
    std::string digits;
    long exponent = 0;
    bool is_fraction = false;
    for (std::size_t i = 0; i < literal.size(); ++i) {
        if (literal[i] == '.') {
            is_fraction = true;
        } else if (literal[i] == 'e' || literal[i] == 'E') {
            exponent += std::stol(literal.substr(i + 1));
            break;
        } else {
            digits += literal[i];
            exponent -= is_fraction;
        }
    }
    digits.erase(0, digits.find_first_not_of('0'));
    return GiNaC::numeric(digits.c_str()) * GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(exponent));
}

/// From a syntax tree to a GiNaC expression; complains with the column of the operation.
class Builder {
public:
    Builder(const SourceText& source, const SyntaxTree& tree, const GiNaC::ex& u, const GiNaC::ex& v)
        : source_(source), tree_(tree), u_(u), v_(v) {}

    GiNaC::ex build() {
        for (const SyntaxNode& node : tree_.nodes) {
            GiNaC::ex value;
            try {
                value = value_of(node);
                check(node, value);
            } catch (const core::Error&) {
                throw;
            } catch (const std::exception&) {  // GiNaC and CLN: poles, 0^0, overflow
                fail(node, "this has no finite value");
            }
            values_.push_back(value);
        }
        return values_.back();
    }

private:
    [[noreturn]] void fail(const SyntaxNode& node, const std::string& problem,
                           const std::string& cure = "the expression must be real and finite") const {
        source_.fail(tree_.component, node.offset, problem, cure);
    }

    GiNaC::ex value_of(const SyntaxNode& node) const {
        const auto operand = [&](std::size_t i) -> const GiNaC::ex& { return values_[node.operands[i]]; };
        switch (node.kind) {
            case SyntaxKind::number: return exact_number(node.text);
            case SyntaxKind::variable_u: return u_;
            case SyntaxKind::variable_v: return v_;
            case SyntaxKind::pi: return GiNaC::Pi;
            case SyntaxKind::e: return GiNaC::exp(GiNaC::ex(1));
            case SyntaxKind::negate: return -operand(0);
            case SyntaxKind::add: return operand(0) + operand(1);
            case SyntaxKind::subtract: return operand(0) - operand(1);
            case SyntaxKind::multiply: return operand(0) * operand(1);
            case SyntaxKind::divide:
                if (operand(1).is_zero()) fail(node, "division by zero");
                return operand(0) / operand(1);
            case SyntaxKind::power: return power(node, node.operands[0], node.operands[1]);
            case SyntaxKind::function: return function(node);
        }
        return 0;
    }

    GiNaC::ex power(const SyntaxNode& node, std::size_t base, std::size_t exponent) const {
        const GiNaC::ex& power = values_[exponent];
        if (tree_.nodes[base].kind == SyntaxKind::e) return GiNaC::exp(power);
        if (GiNaC::is_a<GiNaC::numeric>(power) && GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(power)) > largest_exponent)
            fail(node, "the exponent is too large", "exponents go up to " + std::to_string(largest_exponent));
        // GiNaC would throw, and leak what it was building.
        if (values_[base].is_zero() &&
            !(GiNaC::is_a<GiNaC::numeric>(power) && GiNaC::ex_to<GiNaC::numeric>(power).is_positive()))
            fail(node, "this has no finite value");
        return GiNaC::pow(values_[base], power);
    }

    GiNaC::ex function(const SyntaxNode& node) const {
        const GiNaC::ex& x = values_[node.operands[0]];
        const std::string& name = node.text;
        if (name == "sin") return GiNaC::sin(x);
        if (name == "cos") return GiNaC::cos(x);
        if (name == "tan") return GiNaC::tan(x);
        if (name == "asin") return GiNaC::asin(x);
        if (name == "acos") return GiNaC::acos(x);
        if (name == "atan") return GiNaC::atan(x);
        if (name == "sinh") return GiNaC::sinh(x);
        if (name == "cosh") return GiNaC::cosh(x);
        if (name == "tanh") return GiNaC::tanh(x);
        if (name == "exp") return GiNaC::exp(x);
        if (name == "log") return GiNaC::log(x);
        if (name == "sqrt") return GiNaC::sqrt(x);
        return power(node, node.operands[0], node.operands[1]);
    }

    /// Constants must be real and within the range of double, so must be the coefficients of products (which a power
    /// would raise exactly, at any cost).
    void check(const SyntaxNode& node, const GiNaC::ex& value) const {
        if (!value.has(u_) && !value.has(v_)) check_number(node, value.evalf());
        if (!GiNaC::is_a<GiNaC::mul>(value)) return;
        for (const GiNaC::ex& factor : value)
            if (GiNaC::is_a<GiNaC::numeric>(factor)) check_number(node, factor);
    }

    void check_number(const SyntaxNode& node, const GiNaC::ex& value) const {
        if (!GiNaC::is_a<GiNaC::numeric>(value) || !GiNaC::ex_to<GiNaC::numeric>(value).is_real())
            fail(node, "this is not a real number");
        static const GiNaC::numeric largest(std::numeric_limits<double>::max());
        if (GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(value)) > largest)
            fail(node, "this number is too large", "numbers go up to 1e308");
    }

    const SourceText& source_;
    const SyntaxTree& tree_;
    GiNaC::ex u_, v_;
    std::vector<GiNaC::ex> values_;
};

/// From GiNaC expressions to the canonical graph.
class Converter {
public:
    Converter(Graph& graph, const GiNaC::ex& u, const GiNaC::ex& v) : graph_(graph), u_(u), v_(v) {}

    Multiple convert(const GiNaC::ex& expression) {
        const auto known = converted_.find(expression);
        if (known != converted_.end()) return known->second;
        const Multiple result = convert_new(expression);
        converted_.emplace(expression, result);
        return result;
    }

private:
    Multiple convert_new(const GiNaC::ex& e) {
        if (GiNaC::is_a<GiNaC::numeric>(e)) return {GiNaC::ex_to<GiNaC::numeric>(e).to_double(), Graph::one};
        if (e.is_equal(u_)) return {1, Graph::u};
        if (e.is_equal(v_)) return {1, Graph::v};
        if (e.is_equal(GiNaC::Pi)) return {std::numbers::pi, Graph::one};
        if (GiNaC::is_a<GiNaC::add>(e)) return graph_.sum(operands(e));
        if (GiNaC::is_a<GiNaC::mul>(e)) return graph_.product(operands(e));
        if (GiNaC::is_a<GiNaC::power>(e)) return convert_power(e.op(0), e.op(1));
        if (GiNaC::is_a<GiNaC::function>(e))
            return graph_.function(GiNaC::ex_to<GiNaC::function>(e).get_name(), convert(e.op(0)));
        throw std::domain_error("an expression outside the grammar");
    }

    Multiple convert_power(const GiNaC::ex& base, const GiNaC::ex& exponent) {
        if (GiNaC::is_a<GiNaC::numeric>(exponent)) {
            const auto& number = GiNaC::ex_to<GiNaC::numeric>(exponent);
            const GiNaC::numeric twice = number * 2;
            if (number.is_integer()) return graph_.integer_power(convert(base), number.to_long());
            if (twice.is_integer())
                return graph_.integer_power(graph_.function("sqrt", convert(base)), twice.to_long());
        }
        return graph_.power(convert(base), convert(exponent));
    }

    std::vector<Multiple> operands(const GiNaC::ex& e) {
        std::vector<Multiple> result;
        for (const GiNaC::ex& operand : e) result.push_back(convert(operand));
        return result;
    }

    Graph& graph_;
    GiNaC::ex u_, v_;
    std::unordered_map<GiNaC::ex, Multiple> converted_;
};

std::array<GiNaC::ex, 10> jet(const GiNaC::ex& f, const GiNaC::symbol& u, const GiNaC::symbol& v) {
    const GiNaC::ex f_u = f.diff(u), f_v = f.diff(v);
    const GiNaC::ex f_uu = f_u.diff(u), f_uv = f_u.diff(v), f_vv = f_v.diff(v);
    return {f, f_u, f_v, f_uu, f_uv, f_vv, f_uu.diff(u), f_uu.diff(v), f_uv.diff(v), f_vv.diff(v)};
}

}  // namespace

JetGraph differentiated(const SourceText& source, const std::vector<SyntaxTree>& trees) {
    const std::lock_guard turn(ginac_turn);
    const GiNaC::realsymbol u("u"), v("v");
    JetGraph result;
    Converter converter(result.graph, u, v);
    for (const SyntaxTree& tree : trees) {
        const GiNaC::ex function = Builder(source, tree, u, v).build();
        const auto fail = [&] {
            source.fail(tree.component, tree.root().offset,
                        "this can't be differentiated three times in ordinary numbers", "simplify it");
        };
        JetMultiples& multiples = result.components.emplace_back();
        try {
            const auto derivatives = jet(function, u, v);
            std::transform(derivatives.begin(), derivatives.end(), multiples.begin(),
                           [&](const GiNaC::ex& derivative) { return converter.convert(derivative); });
        } catch (const std::exception&) {  // GiNaC and CLN: poles and numbers out of range
            fail();
        }
        for (const Multiple& multiple : multiples)
            if (!std::isfinite(multiple.coefficient)) fail();
    }
    return result;
}

}  // namespace dsc::geodesic::expression
