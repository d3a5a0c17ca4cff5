#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <limits>
#include <map>

namespace lacuna {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kErrorTolerance = 1e-15;  // of values of order one

class ParameterErrorTest : public testing::Test {
 protected:
  /// Scores by "name unit".
  std::map<std::string, double> scores(const std::vector<double>& model, const std::vector<double>& truth,
                                       const std::vector<std::size_t>& without = {}) const {
    ModelProposal proposal;
    proposal.values = model;
    proposal.without = without;
    std::map<std::string, double> scores;
    for (const ObjectiveScore& score :
         built_catalog().get<ObjectiveMetric>("parameter_error").score(space_, proposal, {truth, robot_}, {}))
      scores[score.name + " " + score.unit] = score.value;
    return scores;
  }
  void free(const std::string& address, const std::string& unit) {
    space_.free.push_back({address, unit, 0.0, 10.0, 1.0, Scale::linear});
  }

  RobotSpec robot_;
  ModelSpace space_{robot_, {}};
};

TEST_F(ParameterErrorTest, EachByItsAddressAndTheMeanOfAGroup) {
  free("body.torso.mass", "kg");
  free("sensor.t1.delay", "s");
  free("body.leg.mass", "kg");
  free("contact.friction", "1");
  const auto errors = scores({3.0, 0.1, 1.5, 0.5}, {2.5, 0.1, 4.0, 0.75});
  EXPECT_THAT(errors,
              testing::ElementsAre(testing::Pair("body.*.mass kg", testing::DoubleNear(1.5, kErrorTolerance)),
                                   testing::Pair("body.leg.mass kg", testing::DoubleNear(2.5, kErrorTolerance)),
                                   testing::Pair("body.torso.mass kg", testing::DoubleNear(0.5, kErrorTolerance)),
                                   testing::Pair("contact.friction 1", testing::DoubleNear(0.25, kErrorTolerance)),
                                   testing::Pair("sensor.t1.delay s", 0.0)));
}

TEST_F(ParameterErrorTest, LeavesOutWhatTheTargetDoesNotHave) {
  for (const char* body : {"a", "b", "c"}) free(std::string("body.") + body + ".mass", "kg");
  const auto errors = scores({3.0, 2.0, 1.0}, {2.0, kUnknown, 4.0});
  EXPECT_THAT(errors, testing::ElementsAre(testing::Pair("body.*.mass kg", testing::DoubleNear(2.0, kErrorTolerance)),
                                           testing::Pair("body.a.mass kg", testing::DoubleNear(1.0, kErrorTolerance)),
                                           testing::Pair("body.c.mass kg", testing::DoubleNear(3.0, kErrorTolerance))));
}

TEST_F(ParameterErrorTest, AddsNoNewtonMetresToNewtons) {
  free("joint.hinge.damping", "N*m*s/rad");
  free("joint.slider.damping", "N*s/m");
  EXPECT_THAT(scores({1.0, 1.0}, {2.0, 3.0}), testing::ElementsAre(testing::Pair("joint.hinge.damping N*m*s/rad", 1.0),
                                                                   testing::Pair("joint.slider.damping N*s/m", 2.0)));
}

TEST_F(ParameterErrorTest, CountsEffectsThatAreOnOrOffAndShouldNotBe) {
  free("body.torso.mass", "kg");
  for (const char* effect : {"grease", "stick", "spring"}) free(std::string("effect.") + effect + ".size", "1");
  space_.effects = {{"grease", true, {1}}, {"stick", true, {2}}, {"spring", false, {3}}, {"fixed", true, {}}};
  const std::vector<double> truth = {2.0, 0.5, kUnknown, kUnknown};
  EXPECT_EQ(scores({2.0, 0.5, 1.0, 1.0}, truth).at("effects 1"), 1.0) << "stick is on; spring is no choice";
  EXPECT_EQ(scores({2.0, 0.5, 1.0, 1.0}, truth, {1}).at("effects 1"), 0.0);
  EXPECT_EQ(scores({2.0, 0.5, 1.0, 1.0}, truth, {1, 3}).at("effects 1"), 0.0) << "of fixed nobody knows";
  EXPECT_EQ(scores({2.0, 0.5, 1.0, 1.0}, truth, {0}).at("effects 1"), 2.0);
}

TEST_F(ParameterErrorTest, LeavesOutTheParametersOfEffectsThatTheModelDoesWithout) {
  for (const char* effect : {"a", "b", "c"}) free(std::string("effect.") + effect + ".size", "1");
  space_.effects = {{"a", true, {0}}, {"b", true, {1}}, {"c", true, {2}}};
  const auto errors = scores({1.0, 2.0, kUnknown}, {3.0, 3.0, 3.0}, {2});
  EXPECT_THAT(errors, testing::ElementsAre(testing::Pair("effect.*.size 1", 1.5), testing::Pair("effect.a.size 1", 2.0),
                                           testing::Pair("effect.b.size 1", 1.0), testing::Pair("effects 1", 1.0)));
}

TEST_F(ParameterErrorTest, RefusesATruthOfAnotherLength) {
  free("body.torso.mass", "kg");
  EXPECT_THROW(scores({1.0}, {}), Error);
}

}  // namespace
}  // namespace lacuna
