#include "end_to_end/program.h"
#include "plugins/built_catalog.h"
#include "support/simulation_run.h"

#include <lacuna/robot_format.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kJoints = 6;
constexpr double kInterval = 0.008, kDuration = 27.0;  // s

/// What the robot file does not have, joint by joint.
constexpr std::array kDampings = {19.2, 22.7, 8.7, 3.2, 3.0, 3.0};  // N·m·s/rad
constexpr std::array kFrictions = {9.0, 11.0, 6.0, 2.0, 2.0, 1.5};  // N·m

std::string urdf() {
  std::ostringstream text;
  text << std::ifstream(LACUNA_SOURCE_DIRECTORY "/experiments/robots/six-joint-arm.urdf").rdbuf();
  return text.str();
}

/// Follows sums of sines with torques that it holds from sample to sample, as the controller of an industrial arm does.
class ArmController : public Controller {
 public:
  void act(double time, std::span<const double> sensors, std::span<double>, std::span<double> torques) const override {
    for (std::size_t j = 0; j < kJoints; ++j) torques[j] = torque(j, time, sensors[j], sensors[kJoints + j]);
  }
  static double torque(std::size_t joint, double time, double position, double velocity) {
    return kProportional[joint] * (goal(joint, time) - position) - kDerivative[joint] * velocity;
  }
  static double goal(std::size_t joint, double time) {
    const auto j = static_cast<double>(joint);
    return kRest[joint] + 0.45 * std::sin((0.9 + 0.17 * j) * time) + 0.15 * std::sin((2.3 + 0.31 * j) * time);
  }

 private:
  static constexpr std::array kRest = {0.0, -0.8, 1.2, -0.4, -1.5, 0.3};                     // rad
  static constexpr std::array kProportional = {5000.0, 6000.0, 1800.0, 150.0, 120.0, 80.0};  // N·m/rad
  static constexpr std::array kDerivative = {250.0, 300.0, 60.0, 0.0, 0.0, 0.0};             // N·m·s/rad
};

/// The arm of the file with friction, its positions before its velocities.
RobotSpec rubbing_arm() {
  RobotSpec robot = built_catalog().get<RobotFormat>("urdf").read({"arm.urdf", urdf()}).robot;
  std::stable_partition(robot.sensors.begin(), robot.sensors.end(),
                        [](const SensorSpec& sensor) { return sensor.kind == SensorKind::joint_position; });
  std::size_t moving = 0;
  for (JointSpec& joint : robot.joints) {
    if (joint.kind != JointKind::hinge) continue;
    joint.damping = kDampings[moving];
    joint.dry_friction = kFrictions[moving++];
  }
  return robot;
}

/// What a driver logs: t, q_0 to q_5, qd_0 to qd_5, effort_0 to effort_5.
std::string recording() {
  SimulationRun run(rubbing_arm(), 1e-3);
  run.engine.control_period = kInterval;
  run.test.drive = std::make_shared<ArmController>();
  std::vector<double> start, times;
  for (std::size_t j = 0; j < kJoints; ++j) start.push_back(ArmController::goal(j, 0.0));
  run.from(start, std::vector<double>(kJoints, 0.0));
  for (int i = 0; i * kInterval <= kDuration; ++i) times.push_back(i * kInterval);
  const SimulationResult result = run.run(times);
  std::mt19937 random(5);  // its numbers are the same everywhere; those of distributions are not
  const auto noise = [&](double size) {
    return size * (static_cast<double>(random()) / 4294967295.0 - 0.5) * std::sqrt(12.0);
  };
  std::string text = "timestamp";
  for (const auto& [name, unit] : {std::pair("q", "rad"), std::pair("qd", "rad/s"), std::pair("effort", "Nm")})
    for (int j = 0; j < kJoints; ++j) text += fmt::format(",{}_{} [{}]", name, j, unit);
  for (std::size_t i = 0; i < times.size(); ++i) {
    text += fmt::format("\n{:.3f}", times[i]);
    const auto row = static_cast<Eigen::Index>(i);
    for (Eigen::Index j = 0; j < kJoints; ++j)
      text += fmt::format(",{:.7f}", result.readings.samples(row, j) + noise(5e-5));
    for (Eigen::Index j = 0; j < kJoints; ++j)
      text += fmt::format(",{:.6f}", result.readings.samples(row, kJoints + j) + noise(1e-3));
    for (std::size_t j = 0; j < kJoints; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      text += fmt::format(",{:.5f}", ArmController::torque(j, times[i], result.readings.samples(row, column),
                                                           result.readings.samples(row, kJoints + column)));
    }
  }
  return text + "\n";
}

double processor_time_of_children() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// From a robot file and a recording to the first comparison, without a blank to fill in.
TEST(TorqueDrivenArm, IsDraftedAndComparedOverASecond) {
  const Program program;
  program.write("arm.urdf", urdf());
  program.write("run.csv", recording());
  const Outcome drafted = program.run({"new", "rig.toml", "--robot", "arm.urdf", "--from", "run.csv"});
  ASSERT_EQ(drafted.exit_code, 0) << drafted.errors;
  EXPECT_THAT(drafted.output, HasSubstr("sensor.wrist_3_position  rad    q_5 [rad]"));
  EXPECT_THAT(drafted.output, HasSubstr("actuator.wrist_3"));
  EXPECT_THAT(drafted.output, Not(HasSubstr("no column matches")));
  EXPECT_THAT(program.read("rig.toml"), Not(HasSubstr("\"FILL IN")));

  const Outcome checked = program.run({"check", "rig.toml"});
  ASSERT_EQ(checked.exit_code, 0) << checked.errors;
  EXPECT_THAT(checked.output, Not(HasSubstr("does not follow the command")));

  const double before = processor_time_of_children();
  const Outcome compared = program.run({"compare", "rig.toml", "--json"});
  ASSERT_EQ(compared.exit_code, 0) << compared.errors;
  EXPECT_LT(processor_time_of_children() - before, 30.0) << "s";
  EXPECT_THAT(compared.output, HasSubstr("predictions restart from the readings every 1 s"));
}

/// Friction differs from joint to joint, and a large armature, with which joints hardly move, explains more of the
/// error than either kind of friction alone.
TEST(TorqueDrivenArm, IsToldTheFrictionOfEachJoint) {
  const Program program;
  program.write("arm.urdf", urdf());
  program.write("run.csv", recording());
  ASSERT_EQ(program.run({"new", "rig.toml", "--robot", "arm.urdf", "--from", "run.csv"}).exit_code, 0);
  const Outcome outcome =
      program.run({"diagnose", "rig.toml", "--among", "armature", "viscous_friction", "coulomb_friction", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const nlohmann::json diagnosis = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(diagnosis["verdict"], "effect_found");
  std::map<std::string, double> values;
  for (const nlohmann::json& effect : diagnosis["ranking"][0]["effects"])
    for (const auto& [name, parameter] : effect["parameters"].items())
      values[effect["effect"].get<std::string>() + " @ " + effect["where"].get<std::string>()] = parameter["value"];
  EXPECT_EQ(values.size(), 2U * kJoints) << outcome.output;
  constexpr std::array kNames = {"pan", "lift", "elbow", "wrist_1", "wrist_2", "wrist_3"};
  for (std::size_t j = 0; j < kJoints; ++j) {
    EXPECT_NEAR(values[fmt::format("viscous_friction @ joint.{}", kNames[j])], kDampings[j], 0.01 * kDampings[j]);
    EXPECT_NEAR(values[fmt::format("coulomb_friction @ joint.{}", kNames[j])], kFrictions[j], 0.01 * kFrictions[j]);
  }
}

}  // namespace
}  // namespace lacuna
