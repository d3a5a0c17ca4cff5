#include "residual_law/force_findings.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

ForceFormula formula_of(const std::vector<ForceFormula::Term>& terms) {
  ForceFormula formula;
  formula.terms = terms;
  return formula;
}

TEST(ForceFormula, IsTheSumOfItsTermsWithFourDigits) {
  EXPECT_EQ(formula_of({{"v*abs(v)", "rad^2/s^2", -0.0213, 0.0}, {"sgn(v)", "1", 0.4, 0.0}}).text(),
            "-0.0213*v*abs(v) + 0.4*sgn(v)");
  EXPECT_EQ(formula_of({{"q", "rad", 1.234567, 0.0}, {"v", "rad/s", -2.0, 0.0}}).text(), "1.235*q - 2*v");
}

TEST(ForceFormula, WritesAConstantWithoutAFactor) {
  EXPECT_EQ(formula_of({{"1", "1", -0.5, 0.0}}).text(), "-0.5");
  EXPECT_EQ(formula_of({{"q", "rad", 1.0, 0.0}, {"1", "1", 0.25, 0.0}}).text(), "1*q + 0.25");
}

TEST(ForceFormula, OfNoTermsIsEmpty) { EXPECT_EQ(ForceFormula{}.text(), ""); }

}  // namespace
}  // namespace lacuna
