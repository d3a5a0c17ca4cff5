#include "residual_law/joint_laws.h"

#include "residual_law/pendulum_data.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

/// The laws beside the fitted model of a pendulum of some truth.
struct LawsOf {
  explicit LawsOf(const PendulumTruth& truth)
      : data(two_recordings(truth)),
        fitted(data.fitted()),
        course(joint_courses(data.data()).at(0)),
        laws(data.data(), fitted.model, data.data().deciding(), fitted.linear, course) {}

  PendulumData data;
  PendulumData::Fitted fitted;
  JointCourse course;
  JointLaws laws;
};

constexpr double kCubic = 0.5;  // N·m/rad³

/// A spring that neither mass nor armature can be, and nothing that is missing; both made once.
const LawsOf& sprung() {
  static const LawsOf one({.damping = 0.02, .cubic = kCubic});
  return one;
}
const LawsOf& plain() {
  static const LawsOf one({.damping = 0.02});
  return one;
}

const FittedLaw& best_law(const JointLaws& laws, const std::string& kind) {
  const FittedLaw* best = nullptr;
  for (const FittedLaw& law : laws.laws())
    if (law.kind == kind && (best == nullptr || law.judged.cost.cost < best->judged.cost.cost)) best = &law;
  return *best;
}

const ForceCurve* curve_over(const std::vector<ForceCurve>& curves, const std::string& quantity) {
  for (const ForceCurve& curve : curves)
    if (curve.of == quantity && !curve.position) return &curve;
  return nullptr;
}

TEST(InNats, IsTheGainWithItsInterval) {
  const Gain gain = in_nats({2.0, 0.5});
  EXPECT_EQ(gain.value, 2.0);
  EXPECT_EQ(gain.standard_error, 0.5);
  EXPECT_NEAR(gain.lower_95, 2.0 - 0.98, 1e-4);
  EXPECT_NEAR(gain.upper_95, 2.0 + 0.98, 1e-4);
}

TEST(JointLawsTest, AreOfEachKindOfSeveralTogetherAndOfAll) {
  std::set<std::string> kinds;
  for (const FittedLaw& law : plain().laws.laws()) kinds.insert(law.kind);
  for (const LawFamily& family : law_families(plain().course)) EXPECT_TRUE(kinds.contains(family.kind)) << family.kind;
  EXPECT_TRUE(kinds.contains("position and velocity"));
  EXPECT_TRUE(plain().laws.plain().functions.empty());
}

/// Damping above the bound of the model's, 0.2 N·m·s/rad, takes energy.
TEST(JointLawsTest, KnowThatALawBrakesTheJoint) {
  const LawsOf damped({.damping = 0.4});
  EXPECT_FALSE(damped.laws.drives(best_law(damped.laws, "velocity")));
}

/// Damping below the bound of the model's, 0, gives energy.
TEST(JointLawsTest, KnowThatALawDrivesTheJoint) {
  const LawsOf driven({.damping = -0.02});
  EXPECT_TRUE(driven.laws.drives(best_law(driven.laws, "velocity")));
}

TEST(JointLawsTest, DrawAndWriteTheForceOfACubicSpring) {
  const std::vector<ForceCurve> curves = sprung().laws.curves();
  const ForceCurve* position = curve_over(curves, "position");
  ASSERT_NE(position, nullptr);
  EXPECT_GT(position->force.front(), position->force.back());
  const FittedLaw& law = best_law(sprung().laws, "position");
  const double gain = gain_of(law.judged, sprung().laws.plain().judged).nats;
  const std::vector<ForceFormula> formulas = sprung().laws.formulas(gain);
  ASSERT_EQ(formulas.size(), 1U);
  EXPECT_EQ(formulas[0].terms[0].text, "q^3");
  EXPECT_NEAR(formulas[0].terms[0].coefficient, -kCubic, 0.2 * kCubic);
  EXPECT_TRUE(sprung().laws.formulas(100.0 * gain).empty()) << "no term makes a tenth of so large a gain";
}

TEST(JointLawsTest, DrawNoCurveThatGainsLessThanItsError) {
  for (const ForceCurve& curve : plain().laws.curves()) {
    const FittedLaw& law = best_law(plain().laws, curve.of);
    EXPECT_TRUE(gain_of(law.judged, plain().laws.plain().judged).is_told()) << curve.of;
  }
  EXPECT_EQ(curve_over(plain().laws.curves(), "position"), nullptr);
}

/// Of the whole residual the answer's part is the whole force.
TEST(JointLawsTest, DrawTheWholeForceWhereThePartIsTheWhole) {
  const std::vector<ForceCurve> curves = sprung().laws.curves_beside(sprung().fitted.linear);
  const ForceCurve* position = curve_over(curves, "position");
  ASSERT_NE(position, nullptr);
  ASSERT_EQ(position->by_answer.size(), position->force.size());
  for (std::size_t i = 0; i < position->force.size(); ++i)
    EXPECT_NEAR(position->by_answer[i], position->force[i], 1e-9) << position->at[i];
}

TEST(JointLawsTest, DrawNothingOfThePartWhereItIsNothing) {
  LinearPrediction nothing = sprung().fitted.linear;
  for (LinearStretch& stretch : nothing.stretches) stretch.residual.setZero();
  const std::vector<ForceCurve> curves = sprung().laws.curves_beside(nothing);
  const ForceCurve* position = curve_over(curves, "position");
  ASSERT_NE(position, nullptr);
  for (const double force : position->by_answer) EXPECT_NEAR(force, 0.0, 1e-9);
}

}  // namespace
}  // namespace lacuna
