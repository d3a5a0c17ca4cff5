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
  std::map<std::string, double> scores(const std::vector<double>& model, const std::vector<double>& truth) const {
    std::map<std::string, double> scores;
    for (const ObjectiveScore& score :
         built_catalog().get<ObjectiveMetric>("parameter_error").score(space_, {model}, {truth, robot_}, {}))
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

TEST_F(ParameterErrorTest, RefusesATruthOfAnotherLength) {
  free("body.torso.mass", "kg");
  EXPECT_THROW(scores({1.0}, {}), Error);
}

}  // namespace
}  // namespace lacuna
