#include "data_checks/scaled_trials.h"

#include "data_checks/recorded_pendulum.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

SensorSpec sensor_of(const std::string& name, SensorKind kind, const std::string& element) {
  SensorSpec sensor;
  sensor.name = name;
  sensor.kind = kind;
  sensor.element = element;
  return sensor;
}

Trial trial_of(const std::string& name, Eigen::Index samples) {
  Trial trial;
  trial.name = name;
  trial.measured.channels = {{"angle", "rad"}, {"force", "N"}};
  trial.measured.times = Eigen::VectorXd::LinSpaced(samples, 0.0, 0.1 * static_cast<double>(samples - 1));
  trial.measured.samples = TimeSeries::Samples::Constant(samples, 2, 6.0);
  trial.sensor_noise = {0.5, 0.25};
  return trial;
}

TEST(JointReadings, AreThePositionAndTheVelocityOfEachMeasuredHingeAndSlider) {
  RobotSpec robot = pendulum_robot();
  for (const auto& [name, kind] : {std::pair("slide", JointKind::slider), std::pair("weld", JointKind::fixed),
                                   std::pair("bare", JointKind::hinge)}) {
    JointSpec joint;
    joint.name = name;
    joint.kind = kind;
    robot.joints.push_back(joint);
  }
  robot.sensors = {
      sensor_of("speed", SensorKind::joint_velocity, "hinge"), sensor_of("way", SensorKind::joint_position, "slide"),
      sensor_of("angle", SensorKind::joint_position, "hinge"), sensor_of("torque", SensorKind::joint_force, "bare")};
  const std::vector<JointReadings> joints = joint_readings(robot);
  ASSERT_EQ(joints.size(), 2U);
  EXPECT_THAT(joints[0].channels, ElementsAre("speed", "angle"));
  EXPECT_TRUE(joints[0].turns);
  EXPECT_THAT(joints[1].channels, ElementsAre("way"));
  EXPECT_FALSE(joints[1].turns);
}

TEST(Beginnings, ShareTheSamplesAmongTheFitTrials) {
  std::vector<Trial> trials = {trial_of("long", 100), trial_of("held out", 100), trial_of("short", 20)};
  trials[1].held_out = true;
  const std::vector<Trial> cut = beginnings(trials, 80);
  ASSERT_EQ(cut.size(), 2U);
  EXPECT_EQ(cut[0].name, "long");
  EXPECT_EQ(cut[0].measured.times.size(), 40);
  EXPECT_EQ(cut[0].measured.samples.rows(), 40);
  EXPECT_EQ(cut[1].measured.times.size(), 20) << "no more than it has";
}

TEST(Beginnings, OfNoFitTrialAreNone) {
  std::vector<Trial> trials = {trial_of("held out", 10)};
  trials[0].held_out = true;
  EXPECT_THAT(beginnings(trials, 80), IsEmpty());
}

TEST(DividedReadings, ChangeTheNamedChannelsAndTheirNoiseAlone) {
  const std::vector<Trial> trials = divided({trial_of("run", 5)}, {"angle"}, 2.0);
  EXPECT_TRUE((trials[0].measured.samples.col(0).array() == 3.0).all());
  EXPECT_TRUE((trials[0].measured.samples.col(1).array() == 6.0).all());
  EXPECT_THAT(trials[0].sensor_noise, ElementsAre(0.25, 0.25));
}

}  // namespace
}  // namespace lacuna
