#include "evaluation/scoring/candidate_simulator.h"
#include "evaluation/robots/robot_key.h"
#include "support/robots.h"

#include <gmock/gmock.h>

#include <functional>
#include <memory>

/// Models that bring a robot of their own.
namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A body on a hinge with a motor, sensors of the joint and a touch sensor.
RobotSpec arm() {
  RobotSpec robot = one_joint(JointKind::hinge, 1.0);
  robot.sensors.push_back(make_sensor("touch", SensorKind::touch, "body"));
  return robot;
}

std::string key_of(const RobotSpec& robot) {
  std::string key;
  append_key(robot, key);
  return key;
}

TEST(RobotKey, EveryNumberAndPlaceCounts) {
  const RobotSpec plain = arm();
  EXPECT_EQ(key_of(plain), key_of(arm()));
  const std::vector<std::function<void(RobotSpec&)>> changes = {
      [](RobotSpec& robot) { robot.bodies[0].position.z() += 1e-15; },
      [](RobotSpec& robot) { robot.bodies[0].orientation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()); },
      [](RobotSpec& robot) {
        robot.bodies[0].shapes.push_back({.kind = ShapeKind::sphere, .size = {0.1, 0, 0}});
      },
      [](RobotSpec& robot) { robot.joints[0].anchor.x() = 0.5; },
      [](RobotSpec& robot) { robot.joints[0].parent = "elsewhere"; },
      [](RobotSpec& robot) { robot.joints[0].kind = JointKind::slider; },
      [](RobotSpec& robot) { robot.actuators[0].transmission.gap = 0.1; },
      [](RobotSpec& robot) { robot.actuators[0].supply_sag = 0.1; },
      [](RobotSpec& robot) { robot.actuators[0].motor.sample_time = 1e-3; },
      [](RobotSpec& robot) { robot.sensors[0].kind = SensorKind::joint_velocity; },
      [](RobotSpec& robot) { robot.sensors.back().element = "another"; },
      [](RobotSpec& robot) { robot.contact.friction = 0.5; },
      [](RobotSpec& robot) { robot.gravity.z() = -1.6; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    RobotSpec changed = arm();
    changes[i](changed);
    EXPECT_NE(key_of(changed), key_of(plain)) << "change " << i;
  }
}

/// Its scale may be a model's free value and come back.
TEST(RobotKey, WhatADeadSensorIsOnCountsToo) {
  RobotSpec one = arm(), other = arm();
  one.sensors.back().scale = other.sensors.back().scale = 0.0;
  other.sensors.back().element = "another";
  EXPECT_NE(key_of(one), key_of(other));
}

TEST(Misfit, ARobotThatDiffersInNumbersAndPlacesFits) {
  RobotSpec built = arm();
  built.bodies[0].mass = 3.0;
  built.joints[0].axis = Eigen::Vector3d::UnitX();
  built.sensors.back().element = "another";
  EXPECT_EQ(misfit(built, arm()), "");
}

TEST(Misfit, NamesKindsAndCountsAreTheExperiments) {
  const auto problem = [](const std::function<void(RobotSpec&)>& change) {
    RobotSpec built = arm();
    change(built);
    return misfit(built, arm());
  };
  EXPECT_THAT(problem([](RobotSpec& robot) { robot.bodies.clear(); }), HasSubstr("has no body"));
  EXPECT_THAT(problem([](RobotSpec& robot) { robot.joints[0].name = "knee"; }), HasSubstr("the joint \"knee\" where"));
  EXPECT_THAT(problem([](RobotSpec& robot) { robot.sensors.push_back(robot.sensors[0]); }), HasSubstr("too many"));
  EXPECT_THAT(problem([](RobotSpec& robot) { robot.joints[0].kind = JointKind::ball; }),
              HasSubstr("has the joint \"joint\" of another kind"));
  EXPECT_THAT(problem([](RobotSpec& robot) { robot.sensors.back().kind = SensorKind::body_position; }),
              HasSubstr("has the sensor \"touch\" of another kind"));
  EXPECT_THAT(problem([](RobotSpec& robot) { robot.actuators[0].kind = ActuatorKind::velocity_servo; }),
              HasSubstr("has the actuator"));
}

/// A ball joint has three readings and a hinge one.
TEST(Misfit, SensorsAndActuatorsStayOnJointsOfTheirKind) {
  RobotSpec experiments = arm();
  experiments.bodies.push_back(experiments.bodies[0]);
  experiments.bodies.back().name = "ball";
  experiments.joints.push_back({.name = "shoulder", .kind = JointKind::ball, .child = "ball"});
  RobotSpec built = experiments;
  built.sensors[0].element = "shoulder";
  EXPECT_THAT(misfit(built, experiments), HasSubstr("on a joint of another kind"));
  built = experiments;
  built.actuators[0].joint = "shoulder";
  EXPECT_THAT(misfit(built, experiments), HasSubstr("has the actuator"));
}

/// A desk for the plain arm, where candidates have no free values.
class CandidateDeskTest : public testing::Test {
 protected:
  CandidateDeskTest() {
    definition_.structure.robot = arm();
    definition_.engine.step = 0.01;
    shared_ = compile(definition_.structure, definition_.engine);
  }
  /// An arm of that inertia about its axis, kg·m².
  static ModelProposal proposal(double inertia) {
    auto robot = std::make_shared<RobotSpec>(arm());
    robot->bodies[0].inertia.yy = inertia;
    return {{}, robot};
  }
  /// The readings of a tenth of a second.
  static TimeSeries::Samples readings(CandidateSimulator& simulator, const ModelProposal& candidate) {
    simulator.take(candidate);
    CommandSeries push;
    push.series.channels = {{"motor", "N*m"}};
    push.series.times = Eigen::VectorXd::Zero(1);
    push.series.samples = TimeSeries::Samples::Ones(1, 1);
    const std::vector<double> times = {0.0, 0.05, 0.1};
    SimulationOptions options;
    options.end_time = times.back();
    options.output_times = times;
    SimulationResult result;
    simulator.simulate({push, 0.1, {}}, options, result);
    EXPECT_EQ(result.ending, Ending::completed) << result.reason;
    return result.readings.samples;
  }

  ModelDefinition definition_;
  std::unique_ptr<CompiledModel> shared_;
};

TEST_F(CandidateDeskTest, WhatCameBeforeChangesNothing) {
  CandidateSimulator fresh(*shared_, &definition_), used(*shared_, &definition_);
  const ModelProposal light = proposal(0.5), heavy = proposal(8.0), plain;
  const TimeSeries::Samples expected = readings(fresh, heavy);
  readings(used, light);
  EXPECT_EQ(readings(used, heavy), expected);
  EXPECT_NE(readings(used, plain), expected);
  EXPECT_NE(readings(used, light), expected);
  EXPECT_EQ(readings(used, heavy), expected);
}

TEST_F(CandidateDeskTest, ARobotThatCannotBeLeavesTheNextOneAlone) {
  CandidateSimulator fresh(*shared_, &definition_), used(*shared_, &definition_);
  const ModelProposal broken = proposal(-1.0), good = proposal(2.0);
  EXPECT_THROW(used.take(broken), Error);
  EXPECT_THROW(used.take(broken), Error) << "and is refused again";
  EXPECT_EQ(readings(used, good), readings(fresh, good));
  EXPECT_THROW(used.take(broken), Error);
  EXPECT_EQ(readings(used, good), readings(fresh, good));
}

TEST_F(CandidateDeskTest, WithoutADefinitionThereAreNoOwnRobots) {
  CandidateSimulator simulator(*shared_, nullptr);
  const ModelProposal own = proposal(2.0), plain;
  EXPECT_THAT([&] { simulator.take(own); }, ThrowsMessage<Error>(HasSubstr("with its own robot")));
  readings(simulator, plain);
}

/// A desk that keeps a robot holds it, too.
TEST_F(CandidateDeskTest, KeepsAsManyRobotsAsTakeTurns) {
  for (const std::size_t kept : {1U, 3U}) {
    CandidateSimulator simulator(*shared_, &definition_, kept);
    std::vector<std::shared_ptr<const RobotSpec>> robots;
    for (const double inertia : {1.0, 2.0, 3.0, 4.0}) {
      const ModelProposal candidate = proposal(inertia);
      robots.push_back(candidate.robot);
      readings(simulator, candidate);
    }
    std::size_t held = 0;
    for (const auto& robot : robots) held += robot.use_count() > 1 ? 1 : 0;
    EXPECT_EQ(held, kept);
    EXPECT_GT(robots.back().use_count(), 1);
  }
}

}  // namespace
}  // namespace lacuna
