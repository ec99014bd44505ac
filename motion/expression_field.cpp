// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/expression_field.h"

#include <muParser.h>

#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/pool.h"

namespace dsc::motion {

namespace {

constexpr std::array<const char*, 3> coordinates = {"x", "y", "z"};
constexpr std::size_t longest = 10'000;  // muParser reads at most 20000 characters

/// One expression, and where it begins in the text.
struct Piece {
    std::size_t offset;
    std::string text;
};

class Source {
public:
    Source(std::string_view text, std::string_view source) : text_(text), source_(source) {}

    [[noreturn]] void fail(std::size_t offset, const std::string& problem, const std::string& cure) const {
        throw core::InputError(std::string(source_), "column " + std::to_string(offset + 1), problem, cure);
    }

    /// The text between the commas that are in no parentheses, but in those around the whole.
    std::vector<Piece> pieces(std::size_t expected) const {
        if (text_.size() > longest) fail(longest, "the expression is too long", "simplify it");
        const auto [begin, end] = inner();
        std::vector<Piece> result;
        std::size_t first = begin;
        int depth = 0;
        for (std::size_t i = begin; i <= end; ++i) {
            const char c = i < end ? text_[i] : ',';
            if (c == '(') ++depth;
            if (c == ')' && --depth < 0) fail(i, "this ')' has no '('", "remove it, or open a parenthesis");
            if (c == ',' && (depth == 0 || i == end)) {
                result.push_back({first, std::string(text_.substr(first, i - first))});
                first = i + 1;
            }
        }
        if (depth > 0) fail(end, "a '(' is not closed", "add a ')'");
        if (result.size() != expected) {
            fail(begin,
                 "has " + std::to_string(result.size()) + " components where " + std::to_string(expected) +
                     " are needed",
                 expected == 3 ? "write (X, Y, Z), for example (-y, x, 0)" : "write (X, Y), for example (-y, x)");
        }
        return result;
    }

private:
    static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

    /// Without blanks around, and without parentheses around the whole: those that hold a comma themselves.
    std::pair<std::size_t, std::size_t> inner() const {
        std::size_t begin = 0, end = text_.size();
        while (begin < end && is_blank(text_[begin])) ++begin;
        while (begin < end && is_blank(text_[end - 1])) --end;
        if (begin == end || text_[begin] != '(' || text_[end - 1] != ')') return {begin, end};
        int depth = 0;
        for (std::size_t i = begin; i + 1 < end; ++i) {
            if (text_[i] == '(') ++depth;
            if (text_[i] == ')' && --depth == 0) return {begin, end};
        }
        return {begin + 1, end - 1};
    }

    std::string_view text_;
    std::string_view source_;
};

double natural_logarithm(double x) { return std::log(x); }

/// The expressions in muParser's bytecode with variables of its own: for one thread at a time.
class Evaluator {
public:
    explicit Evaluator(const std::vector<Piece>& pieces) : parsers_(pieces.size()) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            mu::Parser& parser = parsers_[i];
            for (std::size_t k = 0; k < pieces.size(); ++k) parser.DefineVar(coordinates[k], &variables_[k]);
            parser.DefineVar("t", &variables_[3]);
            parser.DefineConst("pi", std::numbers::pi);
            parser.DefineConst("e", std::numbers::e);
            parser.DefineFun("log", natural_logarithm);
            parser.SetExpr(pieces[i].text);
        }
    }

    /// Throws what muParser has to say about it.
    void compile(std::size_t i) const { parsers_[i].Eval(); }
    int results(std::size_t i) const { return parsers_[i].GetNumResults(); }

    template <int Dimension>
    Vector<Dimension> evaluate(const Vector<Dimension>& x, double t) {
        for (int k = 0; k < Dimension; ++k) variables_[static_cast<std::size_t>(k)] = x[k];
        variables_[3] = t;
        Vector<Dimension> v;
        for (int k = 0; k < Dimension; ++k) v[k] = parsers_[static_cast<std::size_t>(k)].Eval();
        return v;
    }

private:
    std::array<double, 4> variables_{0.5, 0.5, 0.5, 0.5};  // x, y, z, t
    std::vector<mu::Parser> parsers_;
};

/// muParser knows assignments; a velocity must not change a variable.
void reject_assignments(const Source& source, const Piece& piece) {
    const std::string& text = piece.text;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '=') continue;
        const bool is_comparison = (i > 0 && std::string_view("<>!=").find(text[i - 1]) != std::string_view::npos) ||
                                   (i + 1 < text.size() && text[i + 1] == '=');
        if (!is_comparison) source.fail(piece.offset + i, "unexpected '='", "compare by '=='");
    }
}

void check_piece(const Source& source, const Piece& piece, std::size_t i, const Evaluator& evaluator) {
    if (piece.text.find_first_not_of(" \t\n\r") == std::string::npos) {
        source.fail(piece.offset, "the expression is empty", "write 0 for no motion in this direction");
    }
    reject_assignments(source, piece);
    const char* known =
        "known are the coordinates, t, pi, e, sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, "
        "exp, log, sqrt, abs, min, max";
    try {
        evaluator.compile(i);
    } catch (const mu::ParserError& error) {
        const int position = error.GetPos();
        const std::size_t place = position < 0 ? 0 : std::min(static_cast<std::size_t>(position), piece.text.size());
        const std::string token = error.GetToken().empty() ? "" : " at '" + error.GetToken() + "'";
        const bool is_name = error.GetCode() == mu::ecUNASSIGNABLE_TOKEN;
        source.fail(piece.offset + place, (is_name ? "unknown name" : "can't be read") + token,
                    is_name ? known : "write it as in (-y, x + sin(t), 0)");
    }
    if (evaluator.results(i) != 1) source.fail(piece.offset, "has several values", "give one for each coordinate");
}

}  // namespace

template <int Dimension>
VelocityField<Dimension> expression_field(std::string_view text, std::string_view source_name) {
    const Source source(text, source_name);
    std::vector<Piece> pieces = source.pieces(Dimension);
    const Evaluator first(pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) check_piece(source, pieces[i], i, first);
    const auto evaluators = std::make_shared<core::Pool<Evaluator>>(
        [pieces = std::move(pieces)] { return std::make_unique<Evaluator>(pieces); });
    return [evaluators](const Vector<Dimension>& x, double t) {
        return evaluators->use([&](Evaluator& evaluator) { return evaluator.evaluate<Dimension>(x, t); });
    };
}

template VelocityField<2> expression_field<2>(std::string_view text, std::string_view source);
template VelocityField<3> expression_field<3>(std::string_view text, std::string_view source);

}  // namespace dsc::motion
