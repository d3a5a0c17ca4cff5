#include "formula/force_law.h"

#include "formula/formula_parser.h"
#include "foundation/placement_unit.h"
#include "foundation/text/problem.h"
#include "foundation/unit.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(const ForceLaw& law) {
  std::vector<std::string> result;
  for (const LawParameter& parameter : law.parameters) result.push_back(parameter.name);
  return result;
}

std::string unit_of_first(const std::string& formula, const std::map<std::string, double>& values = {}) {
  return unit_in_words(read_force_law(formula, values).parameters.front().unit);
}

TEST(ForceLaw, EachTermsNumberIsAParameterThatStartsThere) {
  const ForceLaw law = read_force_law("-0.02*v - 0.1*sgn(v)*q^2 + sin(3*q)/20 + 1.5", {});
  EXPECT_THAT(names(law), ElementsAre("c_v", "c_sgn_v_q2", "c_sin_3q", "constant"));
  const std::vector<double> starts = {-0.02, -0.1, 0.05, 1.5};
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const LawParameter& parameter = law.parameters[i];
    EXPECT_DOUBLE_EQ(parameter.default_value, starts[i]);
    EXPECT_DOUBLE_EQ(parameter.upper, 100.0 * std::abs(starts[i]));
    EXPECT_DOUBLE_EQ(parameter.lower, -parameter.upper);
    EXPECT_EQ(parameter.neutral, 0.0);
  }
  EXPECT_FALSE(law.uses_command);
}

TEST(ForceLaw, TermsWithTheDirectionOfMotionAreToldApart) {
  const ForceLaw law = read_force_law("-0.1*sgn(v)*q^2 + v*abs(v) - sgn(v)", {});
  EXPECT_TRUE(law.terms[0].along_motion);
  EXPECT_EQ(formula_text(law.terms[0].value), "c_sgn_v_q2*q^2");
  EXPECT_FALSE(law.terms[1].along_motion);
  EXPECT_TRUE(law.terms[2].along_motion);
  EXPECT_EQ(formula_text(law.terms[2].value), "c_sgn_v");
}

TEST(ForceLaw, UnitsFollowFromTheTerm) {
  EXPECT_EQ(unit_of_first("-0.01*v*abs(v)"), "N*m*s^2/rad^2 (N*s^2/m^2 on a slider)");
  EXPECT_EQ(unit_of_first("0.3"), "N*m (N on a slider)");
  EXPECT_EQ(unit_of_first("2*q^3"), "N*m/rad^3 (N/m^3 on a slider)");
  EXPECT_EQ(unit_of_first("sgn(v)*exp(-(v/0.05)^2)"), "N*m (N on a slider)");
  EXPECT_EQ(unit_of_first("q*v"), "N*m*s/rad^2 (N*s/m^2 on a slider)");
  EXPECT_EQ(unit_of_first("sqrt(v^2)"), "N*m*s/rad (N*s/m on a slider)");
  EXPECT_EQ(unit_of_first("sgn(v)*sqrt(abs(v))"), "N*m (N on a slider)");  // of v in rad/s
  EXPECT_EQ(unit_of_first("k*(q - rest)^3", {{"k", 1.0}, {"rest", 0.2}}), "N*m/rad^3 (N/m^3 on a slider)");
}

TEST(ForceLaw, UnitsOfTheCommandHoldForAnyActuator) {
  RobotSpec robot;
  robot.joints.resize(1);
  robot.joints[0].name = "hinge";
  robot.actuators.resize(1);
  robot.actuators[0].joint = "hinge";
  for (const char* formula : {"u", "u*abs(u)", "u*abs(v)", "v/(1 + abs(u))"}) {
    const std::string declared = read_force_law(formula, {}).parameters.front().unit;
    EXPECT_TRUE(parse_unit(unit_at(declared, robot, ElementKind::actuator, 0))) << declared;
  }
  const std::string squared = read_force_law("u*abs(u)", {}).parameters.front().unit;
  EXPECT_EQ(unit_at(squared, robot, ElementKind::actuator, 0), "N*m/(N*m)^2");
}

TEST(ForceLaw, NamesOfItsOwnAreParametersToo) {
  const ForceLaw law = read_force_law("-b*v - c*sgn(v)*(1 + exp(-(v/w)^2)) - 0.3*(q - rest)",
                                      {{"b", 0.02}, {"c", 0.1}, {"w", 0.05}, {"rest", -0.4}});
  EXPECT_THAT(names(law), ElementsAre("b", "c", "term_3", "w", "rest"));
  EXPECT_EQ(law.equation(), "-b*v - c*(1 + exp(-(v/w)^2))*sgn(v) + term_3*(q - rest)");
  EXPECT_EQ(law.parameters[0].default_value, 0.02);
  const LawParameter& w = law.parameters[3];
  EXPECT_EQ(w.scale, Scale::logarithmic);
  EXPECT_EQ(w.unit, "{position}/s");
  EXPECT_EQ(w.neutral, 0.05);
  EXPECT_GT(w.lower, 0.0);
  EXPECT_EQ(law.parameters[4].unit, "{position}");
  EXPECT_LT(law.parameters[4].lower, -0.4);
}

TEST(ForceLaw, ANumberBesideANameStaysAndIsSaid) {
  const ForceLaw law = read_force_law("-0.1*v*w0 + c*q", {{"w0", 1.0}, {"c", 0.5}});
  EXPECT_THAT(names(law), ElementsAre("w0", "c"));
  EXPECT_EQ(law.equation(), "-0.1*w0*v + c*q");
  EXPECT_THAT(law.notes, ElementsAre("-0.1 is constant in the term with w0; a fit changes w0 alone"));
}

TEST(ForceLaw, BoundsHaveFewDigits) {
  const ForceLaw law = read_force_law("-0.144*v*tanh(q/w)", {{"w", 0.123456}});
  EXPECT_EQ(law.parameters[0].lower, -14.4);  // 100 * 0.144 is 14.399999999999999
  EXPECT_EQ(law.parameters[1].lower, 0.00123);
  EXPECT_EQ(law.parameters[1].upper, 12.3);
  EXPECT_EQ(law.parameters[1].default_value, 0.123456);
}

TEST(ForceLaw, ItsTextStandsOnOneLine) { EXPECT_EQ(read_force_law("-0.1*v\n\t*q\r", {}).text, "-0.1*v  *q "); }

TEST(ForceLaw, ThePrecedenceOfSignsIsThatOfArithmetic) {
  const auto text = [](const char* formula) { return read_force_law(formula, {}).equation(); };
  EXPECT_EQ(text("-q^2"), "c_q2*q^2");
  EXPECT_EQ(read_force_law("-q^2", {}).parameters[0].default_value, -1.0);
  EXPECT_EQ(read_force_law("2^3^2*q", {}).parameters[0].default_value, 512.0);
  EXPECT_EQ(read_force_law("8/4/2*q", {}).parameters[0].default_value, 1.0);
  EXPECT_EQ(read_force_law("q - (0.1*v - 2)", {}).parameters[1].default_value, -0.1);
  EXPECT_EQ(text("sin(-(q - 2)*3)"), "term_1*sin(-(q - 2)*3)");
  EXPECT_EQ(text("cos(q/(2*(1 + abs(v))))"), "term_1*cos(q/(2*(1 + abs(v))))");
}

/// Found by fuzzing: each but one would stand in parentheses, more of them than are read.
TEST(ForceLaw, ManyMinusSignsAreWrittenAsOneOrNone) {
  ProblemList problems;
  EXPECT_EQ(formula_text(*parse_formula(std::string(39, '-') + "v", problems)), "-v");
  EXPECT_EQ(formula_text(*parse_formula("-(-v)", problems)), "v");
}

}  // namespace
}  // namespace lacuna
