// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"
#include "grammar/compile.hpp"
#include "grammar/parse.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace spricka::grammar::test_expression {
namespace {

/// One expression read on its own, with a few parameters.
struct Reader {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  ExpressionScope scope;

  Reader() {
    scope.sources = &sources;
    scope.units = *base::make_unit_system("mm", "N");
    scope.values = {{"A", 20.0}, {"R", 36.0}};
  }
  std::optional<base::CompiledExpression> read(const std::string& text,
                                               AllowedVariables fields = AllowedVariables::none) {
    const auto file = sources.add_text("expression", text);
    const auto parsed =
        parse_expression(sources, {file, 0, static_cast<std::uint32_t>(text.size())}, diagnostics);
    return parsed ? compile_expression(*parsed, scope, fields, diagnostics) : std::nullopt;
  }
  double value(const std::string& text) {
    const auto expression = read(text);
    EXPECT_TRUE(expression) << text << '\n' << base::format_messages(sources, diagnostics);
    return expression ? (*expression)(base::Vec3::Zero()) : std::nan("");
  }
  std::string code(const std::string& text, AllowedVariables fields = AllowedVariables::none) {
    diagnostics = {};
    EXPECT_FALSE(read(text, fields)) << text;
    return diagnostics.messages().empty() ? "" : diagnostics.messages().front().code;
  }
};

TEST(Expression, FollowsThePrecedenceOfAlgebra) {
  Reader r;
  EXPECT_EQ(r.value("2+3*4"), 14.0);
  EXPECT_EQ(r.value("(2+3)*4"), 20.0);
  EXPECT_EQ(r.value("8-4-2"), 2.0);
  EXPECT_EQ(r.value("16/4/2"), 2.0);
  EXPECT_EQ(r.value("2*3^2"), 18.0);
}

TEST(Expression, PowerBindsToTheRightAndBeforeTheSign) {
  Reader r;
  EXPECT_EQ(r.value("2^3^2"), 512.0);
  EXPECT_EQ(r.value("-2^2"), -4.0);
  EXPECT_EQ(r.value("(-2)^2"), 4.0);
  EXPECT_EQ(r.value("2^-1"), 0.5);
  EXPECT_EQ(r.value("2^-2^0"), 0.5);
  EXPECT_EQ(r.value("--3"), 3.0);
  EXPECT_EQ(r.value("3 - -2"), 5.0);
}

TEST(Expression, KnowsItsFunctions) {
  Reader r;
  EXPECT_EQ(r.value("sqrt(a+5)"), 5.0);
  EXPECT_EQ(r.value("abs(-3)"), 3.0);
  EXPECT_DOUBLE_EQ(r.value("sin(pi/6)"), 0.5);
  EXPECT_DOUBLE_EQ(r.value("cos(60[deg])"), 0.5);
  EXPECT_DOUBLE_EQ(r.value("tan(pi/4)"), 1.0);
  EXPECT_DOUBLE_EQ(r.value("atan2(1, 0)"), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(r.value("log(exp(2))"), 2.0);
  EXPECT_EQ(r.value("min(3, 2)+MAX(1, 5, 4)"), 7.0);
}

TEST(Expression, ComparesAndJoins) {
  Reader r;
  EXPECT_EQ(r.value("1 < 2 and 2 <= 2 and 3 > 2 and 3 >= 3 and 1 == 1"), 1.0);
  EXPECT_EQ(r.value("1 > 2 or 2 == 3"), 0.0);
  EXPECT_EQ(r.value("(1 > 2 or 2 > 1) and 1 < 2"), 1.0);
  EXPECT_EQ(r.value("1 + 1 < 1 * 3"), 1.0);
}

TEST(Expression, NamesAreCaseInsensitive) {
  Reader r;
  EXPECT_EQ(r.value("r/2 + R/2 + SQRT(4)*PI/pi"), 38.0);
}

TEST(Expression, UnitsBecomeDeckUnits) {
  Reader r;
  EXPECT_EQ(r.value("210[GPa]"), 210000.0);
  EXPECT_EQ(r.value("(1+1)[in]"), 50.8);
  EXPECT_EQ(r.value("0.084[mm]"), 0.084);
  EXPECT_EQ(r.value("2[kN]/4[mm^2]"), 500.0);
  EXPECT_DOUBLE_EQ(r.value("90[deg]"), std::numbers::pi / 2);
}

TEST(Expression, FieldsStayOpenTillThePointIsKnown) {
  Reader r;
  const auto e = r.read("1e-3*(x+y/2) + R*0", AllowedVariables::position);
  ASSERT_TRUE(e);
  EXPECT_FALSE(e->is_constant());
  EXPECT_EQ((*e)(base::Vec3(2.0, 4.0, 0.0)), 1e-3 * 4.0);
  const auto polar = r.read("rho*cos(theta) - x", AllowedVariables::position);
  ASSERT_TRUE(polar);
  EXPECT_NEAR((*polar)(base::Vec3(-3.0, 4.0, 1.0)), 0.0, 1e-14);
}

TEST(Expression, ParametersAreFoldedToOneNumber) {
  Reader r;
  const auto e = r.read("2*R/sqrt(4) + sin(0)");
  ASSERT_TRUE(e);
  EXPECT_EQ(e->code.size(), 1U);
}

TEST(Expression, MistakesAreNamed) {
  Reader r;
  EXPECT_EQ(r.code("2 +"), "E101");
  EXPECT_EQ(r.code("(2"), "E101");
  EXPECT_EQ(r.code("2 3"), "E101");
  EXPECT_EQ(r.code(""), "E101");
  EXPECT_EQ(r.code("1.0d0"), "E103");
  EXPECT_EQ(r.code("1e999"), "E103");
  EXPECT_EQ(r.code("b"), "E201");
  EXPECT_EQ(r.code("root(2)"), "E202");
  EXPECT_EQ(r.code("sqrt(2, 3)"), "E203");
  EXPECT_EQ(r.code("sqrt"), "E203");
  EXPECT_EQ(r.code("2[furlong]"), "E204");
  EXPECT_EQ(r.code("1/0"), "E206");
  EXPECT_EQ(r.code("sqrt(-1)"), "E206");
  EXPECT_EQ(r.code("x + 1"), "E209");
  EXPECT_EQ(r.code("1 < 2 and 2 < 3 or 3 < 4"), "E102");
  EXPECT_EQ(r.code(std::string(100000, '(')), "E102");
  EXPECT_EQ(r.code(std::string(100000, '-') + "1"), "E102");
  EXPECT_EQ(r.code("\xC3\xA4 + 1"), "E101");
}

TEST(Expression, MessagesAreFreeOfMangledNames) {
  for (const std::string text :
       {"2 +", "(", "f(", "f(1,", "1 <", "2[", "^", "1 and", "sin 2", ")"}) {
    Reader r;
    EXPECT_FALSE(r.read(text)) << text;
    const std::string message = base::format_messages(r.sources, r.diagnostics);
    EXPECT_EQ(message.find("boost"), std::string::npos) << message;
    EXPECT_EQ(message.find("N7spricka"), std::string::npos) << message;
  }
}

} // namespace
} // namespace spricka::grammar::test_expression
