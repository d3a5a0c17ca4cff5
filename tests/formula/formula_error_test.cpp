#include "formula/force_law.h"
#include "foundation/text/problem.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// A formula that cannot be one, and a sentence for each fault with its place.
struct Bad {
  const char* formula;
  std::vector<std::string> sentences;
};

std::vector<Bad> bad_formulas() {
  return {
      {"", {":1:1: the formula is empty"}},
      {"  ", {":1:3: the formula is empty"}},
      {"-0.01*v*abs(v", {":1:12: the ( of abs has no matching )"}},
      {"0.1*(q + v", {":1:5: this ( has no matching )"}},
      {"q)", {":1:2: this ) has no matching ("}},
      {"2q", {":1:2: an operator is missing before \"q\"; write products with *"}},
      {"(2 q)", {":1:4: an operator is missing before \"q\""}},
      {"v(2)", {":1:1: an operator is missing between \"v\" and ("}},
      {"v +", {":1:4: the formula ends where"}},
      {"v*/2", {":1:3: a number, q, v, u or a function is expected before \"/\""}},
      {"sign(v) + sinn(q)",
       {":1:1: there is no function sign", ":1:11: there is no function sinn (did you mean \"sin\"?)"}},
      {"abs*v", {":1:1: abs is a function"}},
      {"Q + 0.5*_x", {":1:1: \"Q\" is not a valid parameter name", ":1:9: \"_x\" is not a valid parameter name"}},
      {"0,5*v + |v| + v**2", {":1:2: \",\"", ":1:9: \"|\"", ":1:11: \"|\"", ":1:16: \"**\""}},
      {"0.1\u2212v", {":1:4: \"\u2212\" is not allowed in a formula; write minus as -"}},
      {"\u00e4", {":1:1: \"\u00e4\" is not allowed"}},
      {"tau=v", {":1:4: \"=\" is not allowed in a formula; give the right-hand side alone"}},
      {"v^q + q^v", {":1:3: an exponent must be a number, as in v^2, not q", ":1:9: an exponent must be a number"}},
      {"1e999*v", {":1:1: \"1e999\" is outside the range"}},
      {"v + exp(1000)*q", {":1:5: exp(1000) is not a finite number"}},
      {"v/0 + 1/(2 - 2)*q", {":1:3: a division by 0", ":1:10: a division by 0"}},
      {"0*v", {":1:1: the coefficient of the term v must be finite and not 0"}},
      {"1e307*v", {":1:1: the coefficient of the term v must be finite"}},
      {"q + 2*q", {":1:5: there are two terms with q"}},
      {"b*v + c*q", {":1:1: the parameter b has no value; add --value b=NUMBER", ":1:7: the parameter c"}},
      {"q/v", {":1:3: v may be zero"}},
      {"v^-1", {":1:1: v may be zero"}},
      {"sqrt(q)", {":1:1: q may be negative and then has no root"}},
      {"v^1.5", {":1:1: v may be negative and then has no power of 1.5"}},
      {"sqrt(1 - q^2)", {"may be negative"}},
  };
}

TEST(Formula, WhatIsWrongWithItIsToldWithItsPlaces) {
  for (const auto& [formula, sentences] : bad_formulas()) {
    SCOPED_TRACE(formula);
    try {
      read_force_law(formula, {});
      ADD_FAILURE() << "it was taken";
    } catch (const BadInput& error) {
      EXPECT_EQ(error.problems().size(), sentences.size()) << error.what();
      for (const std::string& sentence : sentences) EXPECT_THAT(error.what(), HasSubstr(sentence));
    }
  }
}

TEST(Formula, NeitherLengthNorDepthOverflowsAnything) {
  for (const std::string& formula : {std::string(100000, '('), std::string(1900, '-') + "v", std::string(100000, '1'),
                                     std::string(1000, '(') + "v" + std::string(1000, ')')})
    EXPECT_THROW(read_force_law(formula, {}), BadInput);
  std::string sum = "q";
  while (sum.size() < 1900) sum += "+v*q";
  EXPECT_THAT([&] { read_force_law(sum, {}); }, testing::ThrowsMessage<BadInput>(HasSubstr("two terms with v*q")));
}

TEST(Formula, ValuesMustFitItsNames) {
  const auto message = [](const char* formula, const std::map<std::string, double>& values) -> std::string {
    try {
      read_force_law(formula, values);
    } catch (const BadInput& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(message("damping*v", {{"damping", 0.1}, {"dampin", 1.0}}),
              HasSubstr("--value: dampin is no parameter of the formula (did you mean \"damping\"?)"));
  EXPECT_THAT(message("b*v", {{"b", 0.0}}), HasSubstr("the value of b must be a number other than 0"));
  EXPECT_THAT(message("0.1*tanh(v/w)", {{"w", -0.1}}), HasSubstr(":1:12: w divides or scales something"));
  EXPECT_EQ(message("0.1*tanh(v/w)", {{"w", 0.1}}), "");
  EXPECT_THAT(
      message("-b*v - b*q", {{"b", 0.1}}),
      HasSubstr(":1:2: b has the unit N*m*s/rad (N*s/m on a slider) in one place and N*m/rad (N/m on a slider) in "
                "another; use two names, as in b and b_2"));
  EXPECT_THAT(message("0.1*tanh(v/w) + 0.2*tanh(q/w)", {{"w", 0.1}}),
              HasSubstr(":1:12: w has the unit rad/s (m/s on a slider) in one place and rad (m on a slider)"));
  EXPECT_EQ(message("-b*v - b*q*tanh(v/w)/(w + abs(v))", {{"b", 0.1}, {"w", 0.1}}).find("w has"), std::string::npos);
  EXPECT_EQ(message("-b*v - b*v*q^2/(0.1 + q^2)", {{"b", 0.1}}), "");
}

}  // namespace
}  // namespace lacuna
