// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/expression/syntax.h"

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "geodesic/expression_metric.h"

using namespace dsc;
using namespace dsc::geodesic;

namespace {

struct BadText {
    std::string text;
    std::string place;
    std::string problem;
};

void check_table(const std::vector<BadText>& table, const auto& build) {
    for (const BadText& bad : table) {
        INFO(bad.text);
        try {
            build(bad.text);
            FAIL_CHECK("accepted");
        } catch (const core::InputError& error) {
            INFO(error.what());
            CHECK(error.source() == "--option");
            CHECK(error.place() == bad.place);
            CHECK_THAT(error.what(), Catch::Contains(bad.problem));
            CHECK_THAT(error.what(), Catch::Contains("; "));  // a cure
            CHECK_THAT(error.what(), !Catch::Contains("\n"));
        }
    }
}

}  // namespace

TEST_CASE("errors in expressions carry component, column and cure") {
    check_table(
        {
            {"x=foo+1;y=v;z=0", "x, column 3", "unknown name 'foo'"},
            {"x=u;y=2*bar(v);z=0", "y, column 9", "unknown name 'bar'"},
            {"x=U;y=v;z=0", "x, column 3", "unknown name 'U'"},
            {"x=nan;y=v;z=0", "x, column 3", "unknown name 'nan'"},
            {"x=u;y=inf*v;z=0", "y, column 7", "unknown name 'inf'"},
            {"x=(u+1;y=v;z=0", "x, column 3", "this '(' has no ')'"},
            {"x=sin(u;y=v;z=0", "x, column 6", "this '(' has no ')'"},
            {"x=u);y=v;z=0", "x, column 4", "this ')' has no '('"},
            {"x=sin u;y=v;z=0", "x, column 3", "the function 'sin' has no argument"},
            {"x=sin();y=v;z=0", "x, column 7", "an argument of 'sin' is missing"},
            {"x=sin(u,v);y=v;z=0", "x, column 9", "too many arguments for 'sin'"},
            {"x=pow(u);y=v;z=0", "x, column 8", "an argument of 'pow' is missing"},
            {"x=pow(u,);y=v;z=0", "x, column 9", "an argument of 'pow' is missing"},
            {"x=1,5;y=v;z=0", "x, column 4", "unexpected ','"},
            {"x=2u;y=v;z=0", "x, column 4", "expected an operator before 'u'"},
            {"x=u v;y=v;z=0", "x, column 5", "expected an operator before 'v'"},
            {"x=2e;y=v;z=0", "x, column 4", "expected an operator before 'e'"},
            {"x=(u)(v);y=v;z=0", "x, column 6", "expected an operator before '('"},
            {"x=u**2;y=v;z=0", "x, column 5", "found '*'; write '^' for powers"},
            {"x=u+;y=v;z=0", "x, column 5", "found ';'"},
            {"x=u;y=v;z=1+", "z, column 13", "found the end of the text"},
            {"x=*u;y=v;z=0", "x, column 3", "found '*'"},
            {"x=u%2;y=v;z=0", "x, column 4", "expected an operator before '%'"},
            {"x=1.2.3;y=v;z=0", "x, column 3", "'1.2.3' is not a number"},
            {"x=.;y=v;z=0", "x, column 3", "'.' is not a number"},
            {"x=1e999;y=v;z=0", "x, column 3", "out of range"},
            {"x=u+1e-999;y=v;z=0", "x, column 5", "out of range"},
            {"x=;y=v;z=0", "x, column 3", "the expression is empty"},
            {"x=u;y=v;z= ", "z, column 12", "the expression is empty"},
            {"x=u;y=v", "column 8", "component 'z' is missing"},
            {"", "column 1", "component 'x' is missing"},
            {"x=u;y=v;z=0;x=1", "x, column 13", "component 'x' is given twice"},
            {"x=u;y=v;w=0", "column 9", "unknown component 'w'"},
            {"E=1;F=0;G=1", "column 1", "unknown component 'E'"},
            {"u+v", "column 1", "unknown component 'u'"},
            {"x:u;y=v;z=0", "x, column 2", "expected '=' but found ':'"},
            {"x=u y=v;z=0", "x, column 5", "expected an operator before 'y'"},
            {"x=u=v;y=v;z=0", "x, column 4", "unexpected '='"},
            {"x=u;;y=v;z=0", "column 5", "expected the name of a component but found ';'"},
            {"=u;y=v;z=0", "column 1", "expected the name of a component but found '='"},
            // Columns count characters, not bytes.
            {"x=u;y=\xCF\x80*v;z=0", "y, column 7", "found '\xCF\x80'"},
            {"x=u; y=v*(\xCE\xBB+foo);z=0", "y, column 11", "found '\xCE\xBB'"},
            {std::string("x=") + std::string(500, '('), "x, column 203", "nested too deeply"},
            {std::string("x=") + std::string(500, '-') + "u", "x, column 203", "nested too deeply"},
        },
        [](const std::string& text) { ExpressionEmbedding(text, {}, "--option"); });
}

TEST_CASE("constants without a real finite value carry the column of their operation") {
    check_table(
        {
            {"E=1/0;F=0;G=1", "E, column 4", "division by zero"},
            {"E=1;F=u/(v-v);G=1", "F, column 8", "division by zero"},
            {"E=0^-1;F=0;G=1", "E, column 4", "no finite value"},
            {"E=1;F=0^u;G=1", "F, column 8", "no finite value"},
            {"E=(-8)^(1/3);F=0;G=1", "E, column 7", "not a real number"},
            {"E=1;F=0;G=1+sqrt(-1)", "G, column 13", "not a real number"},
            {"E=1;F=0;G=log(-2)", "G, column 11", "not a real number"},
            {"E=1;F=0;G=log(0)", "G, column 11", "no finite value"},
            {"E=1;F=0;G=acos(2)", "G, column 11", "not a real number"},
            {"E=1;F=0;G=tan(pi/2)", "G, column 11", "no finite value"},
            {"E=exp(1000);F=0;G=1", "E, column 3", "too large"},
            {"E=9^9^9;F=0;G=1", "E, column 4", "the exponent is too large; exponents go up to 1000"},
            {"E=u^1001;F=0;G=1", "E, column 4", "the exponent is too large; exponents go up to 1000"},
            {"E=pow(1e300, 3);F=0;G=1", "E, column 3", "too large"},
            {"E=((1e300*u)^999)^999;F=0;G=1", "E, column 13", "too large"},
        },
        [](const std::string& text) { ExpressionMetric(text, {}, "--option"); });
}

TEST_CASE("trees keep the places of their parts") {
    const expression::SourceText source{"--option", "x = 1 + sin( u )"};
    const expression::SyntaxTree tree = expression::parse_components(source, {"x"}).front();
    CHECK(tree.component == "x");
    CHECK(tree.root().kind == expression::SyntaxKind::add);
    CHECK(tree.root().offset == 6);
    CHECK(tree.nodes[tree.root().operands[1]].text == "sin");
    CHECK(tree.nodes[tree.root().operands[1]].offset == 8);
}
