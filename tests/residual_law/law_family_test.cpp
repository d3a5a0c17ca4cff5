#include "residual_law/law_family.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

/// A motion that goes evenly through positions of −2 to 2, velocities of −4 to 4, 10 s and commands of 0 to 1 V.
JointCourse even_course(const std::string& position_unit = "rad", const std::string& command_unit = "V") {
  JointCourse course{"hinge", position_unit, "N*m", command_unit, {{}}};
  constexpr int kMoments = 401;
  for (int i = 0; i < kMoments; ++i) {
    const double share = static_cast<double>(i) / (kMoments - 1);
    course.trials[0].push_back(
        {.position = -2.0 + 4.0 * share, .velocity = -4.0 + 8.0 * share, .command = share, .time = 10.0 * share});
  }
  return course;
}

const LawFamily* family_of(const std::vector<LawFamily>& all, const std::string& kind) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const LawFamily& one) { return one.kind == kind; });
  return found == all.end() ? nullptr : &*found;
}

const ForceTerm& term_of(const std::vector<ForceTerm>& all, const std::string& text) {
  return *std::find_if(all.begin(), all.end(), [&](const ForceTerm& one) { return one.text == text; });
}

bool has_term(const std::vector<ForceTerm>& all, const std::string& part) {
  return std::any_of(all.begin(), all.end(),
                     [&](const ForceTerm& one) { return one.text.find(part) != std::string::npos; });
}

std::vector<double> at(const LawFamily& family, const JointMoment& moment) {
  std::vector<double> values;
  for (const auto& function : family.functions) values.push_back(function(moment));
  return values;
}

/// So that each is the force at its knot, and the line between them.
TEST(LawFamilies, OfAPositionAreLinearBetweenKnots) {
  const LawFamily position = *family_of(law_families(even_course()), "position");
  ASSERT_EQ(position.functions.size(), 9U);
  EXPECT_DOUBLE_EQ(position.places.front(), -2.0);
  EXPECT_DOUBLE_EQ(position.places.back(), 2.0);
  EXPECT_THAT(at(position, {.position = position.places[3]}),
              testing::ElementsAre(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0));
  const double between = 0.75 * position.places[3] + 0.25 * position.places[4];
  const std::vector<double> values = at(position, {.position = between});
  EXPECT_NEAR(values[3], 0.75, 1e-12);
  EXPECT_NEAR(values[4], 0.25, 1e-12);
}

TEST(LawFamilies, OfAPositionStayBeyondTheKnots) {
  const LawFamily position = *family_of(law_families(even_course()), "position");
  EXPECT_EQ(at(position, {.position = 50.0}).back(), 1.0);
  EXPECT_EQ(at(position, {.position = -50.0}).front(), 1.0);
}

TEST(LawFamilies, HaveTheirKnotsAtQuantiles) {
  JointCourse course = even_course();
  for (JointMoment& moment : course.trials[0])
    moment.position = std::pow(moment.position + 2.0, 3);  // most of it small
  const LawFamily position = *family_of(law_families(course), "position");
  EXPECT_NEAR(position.places[4], std::pow(2.0, 3), 1e-9) << "the median";
}

/// Coulomb friction of −3 is one function alone.
TEST(LawFamilies, OfAVelocityMayJumpAtZero) {
  const LawFamily velocity = *family_of(law_families(even_course()), "velocity");
  ASSERT_EQ(velocity.functions.size(), 12U) << "eleven knots and the jump";
  EXPECT_EQ(velocity.functions.back()({.velocity = 1e-6}), 1.0);
  EXPECT_EQ(velocity.functions.back()({.velocity = -1e-6}), -1.0);
  EXPECT_EQ(velocity.functions.back()({.velocity = 0.0}), 0.0);
  EXPECT_TRUE(std::is_sorted(velocity.places.begin(), velocity.places.end()));
  EXPECT_EQ(std::count(velocity.places.begin(), velocity.places.end(), 0.0), 0) << "drawn on both sides of the jump";
  EXPECT_EQ(std::count(velocity.places.begin(), velocity.places.end(), 4e-3), 1);
}

TEST(LawFamilies, OfAHingeMayRepeatWithItsTurns) {
  EXPECT_NE(family_of(law_families(even_course()), "position, periodically"), nullptr);
  EXPECT_EQ(family_of(law_families(even_course("m")), "position, periodically"), nullptr);
}

TEST(LawFamilies, OfTheCommandAreOnlyOfADrivenJoint) {
  for (const std::string kind : {"command", "the past of the command", "command and velocity", "command and time"}) {
    EXPECT_NE(family_of(law_families(even_course()), kind), nullptr) << kind;
    EXPECT_EQ(family_of(law_families(even_course("rad", "")), kind), nullptr) << kind;
  }
}

/// A delayed command is the command and what it was less what it is.
TEST(LawFamilies, OfThePastOfTheCommandAreNothingForASteadyOne) {
  const LawFamily past = *family_of(law_families(even_course()), "the past of the command");
  JointMoment moment{.command = 0.7};
  moment.slow_command.fill(0.7);
  EXPECT_THAT(at(past, moment), testing::Each(0.0));
  moment.slow_command[1] = 0.9;
  EXPECT_NEAR(at(past, moment)[1], 0.2, 1e-12);
}

TEST(LawFamilies, KnowWhichOfThemFollowTheVelocity) {
  for (const LawFamily& family : law_families(even_course())) {
    const bool expected = family.kind.starts_with("velocity") || family.kind == "the past of the motion" ||
                          family.kind == "time and velocity";
    EXPECT_EQ(family.follows_velocity, expected) << family.kind;
  }
}

TEST(LawFamilies, OfAQuantityThatDoesNotVaryAreNone) {
  JointCourse course = even_course();
  for (JointMoment& moment : course.trials[0]) moment.command = 0.5;
  EXPECT_EQ(family_of(law_families(course), "command"), nullptr);
}

TEST(ForceTerms, AreWhatTheirTextSays) {
  const std::vector<ForceTerm> terms = force_terms(even_course());
  const JointMoment moment{.position = -0.5, .velocity = -2.0, .command = -3.0};
  const std::vector<std::pair<std::string, double>> expected = {{"1", 1.0},
                                                                {"q", -0.5},
                                                                {"q^2", 0.25},
                                                                {"q^3", -0.125},
                                                                {"q*abs(q)", -0.25},
                                                                {"sgn(v)", -1.0},
                                                                {"v", -2.0},
                                                                {"abs(v)", 2.0},
                                                                {"v*abs(v)", -4.0},
                                                                {"v^3", -8.0},
                                                                {"q*v", 1.0},
                                                                {"q^2*v", -0.5},
                                                                {"sgn(v)*q", 0.5},
                                                                {"sgn(v)*abs(q)", -0.5},
                                                                {"u", -3.0},
                                                                {"abs(u)", 3.0},
                                                                {"u*abs(u)", -9.0},
                                                                {"u^3", -27.0},
                                                                {"sgn(u)", -1.0},
                                                                {"sgn(v)*abs(u)", -3.0},
                                                                {"u*abs(v)", -6.0},
                                                                {"sin(2*q)", std::sin(-1.0)},
                                                                {"cos(q)", std::cos(-0.5)},
                                                                {"sgn(v)*cos(3*q)", -std::cos(-1.5)},
                                                                {"sgn(v)*sqrt(abs(v))", -std::sqrt(2.0)}};
  for (const auto& [text, value] : expected) {
    ASSERT_TRUE(has_term(terms, text)) << text;
    EXPECT_NEAR(term_of(terms, text).of(moment), value, 1e-12) << text;
  }
}

/// Speeds are even up to 4 rad/s: three tenths of them are below 1.2.
TEST(ForceTerms, FadeWithTheUsualSpeeds) {
  const std::vector<ForceTerm> terms = force_terms(even_course());
  ASSERT_TRUE(has_term(terms, "sgn(v)*exp(-(v/1.2)^2)"));
  EXPECT_NEAR(term_of(terms, "sgn(v)*exp(-(v/1.2)^2)").of({.velocity = 1.2}), std::exp(-1.0), 1e-12);
  EXPECT_NEAR(term_of(terms, "tanh(v/1.2)").of({.velocity = -2.4}), std::tanh(-2.0), 1e-12);
}

TEST(ForceTerms, HaveNoCommandWhereThereIsNoneAndNoWavesOnASlider) {
  const std::vector<ForceTerm> terms = force_terms(even_course("m", ""));
  EXPECT_FALSE(has_term(terms, "u"));
  EXPECT_FALSE(has_term(terms, "sin("));
  EXPECT_EQ(term_of(terms, "v*abs(v)").unit, "m^2/s^2");
}

}  // namespace
}  // namespace lacuna
