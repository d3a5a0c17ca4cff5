#include "where_it_fails/model_state.h"

#include "where_it_fails/wheel_rig.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

/// A trial of `seconds` in steps of 10 ms.
Trial trial_of(const RobotSpec& robot, double seconds) {
  const auto samples = static_cast<Eigen::Index>(std::lround(100.0 * seconds)) + 1;
  Trial trial;
  trial.measured.channels = {{"angle", "rad"}};
  trial.measured.times = Eigen::VectorXd::LinSpaced(samples, 0.0, seconds);
  trial.measured.samples = TimeSeries::Samples::Zero(samples, 1);
  trial.commands.series.channels = command_channels(robot);
  trial.commands.series.times = trial.measured.times;
  trial.commands.series.samples =
      TimeSeries::Samples::Constant(samples, static_cast<Eigen::Index>(robot.actuators.size()), 2.0);
  return trial;
}

ModelDefinition model_of(const RobotSpec& robot) {
  ModelDefinition definition;
  definition.structure.robot = robot;
  definition.engine.step = 0.001;
  return definition;
}

/// 2 N·m on 1 kg·m².
TEST(ModelStates, AreThePositionsVelocitiesAndLoadsOfTheFreeRun) {
  const ModelStates states(model_of(wheel()));
  const std::optional<ModelState> state = states.of(trial_of(wheel(), 1.0), {{0.5}, {-1.0}}, {});
  ASSERT_TRUE(state);
  ASSERT_EQ(state->positions.rows(), 101);
  for (const Eigen::Index i : {0, 40, 100}) {
    const double t = 0.01 * static_cast<double>(i);
    EXPECT_NEAR(state->positions(i, 0), 0.5 - t + t * t, 2e-3) << t;
    EXPECT_NEAR(state->velocities(i, 0), -1.0 + 2.0 * t, 1e-6) << t;
  }
  EXPECT_NEAR(state->loads(50, 0), 2.0, 1e-9);
  EXPECT_EQ(state->contacts.cols(), 0) << "no ground";
}

/// A ball of 0.1 m that is let go at 1 m reaches the ground after 0.43 s.
TEST(ModelStates, SayWhetherABodyTouchesTheGround) {
  RobotSpec robot;
  robot.name = "ball";
  BodySpec ball;
  ball.name = "ball";
  ball.inertia = {.xx = 0.004, .yy = 0.004, .zz = 0.004};
  ball.position = {0.0, 0.0, 1.0};
  ball.shapes.resize(1);
  ball.shapes[0].kind = ShapeKind::sphere;
  ball.shapes[0].size = {0.1, 0.0, 0.0};
  robot.bodies = {ball};
  JointSpec joint;
  joint.name = "air";
  joint.kind = JointKind::free;
  joint.child = "ball";
  robot.joints = {joint};
  robot.contact.ground = true;
  robot.contact.stiffness = 1e4;
  robot.contact.damping = 100.0;
  const ModelStates states(model_of(robot));
  EXPECT_THAT(states.bodies(), testing::ElementsAre("ball"));
  const std::vector<double> none(6, 0.0);
  const std::optional<ModelState> state = states.of(trial_of(robot, 0.6), {none, none}, {});
  ASSERT_TRUE(state);
  EXPECT_TRUE((state->contacts.col(0).head(41).array() == -1.0).all());
  EXPECT_EQ(state->contacts.col(0).tail(18).maxCoeff(), 1.0);
  ASSERT_EQ(state->positions.cols(), 6);
  EXPECT_TRUE(state->positions.isZero()) << "of free joints nothing is read";
}

TEST(ModelStates, AreNoneWhereTheTrialCannotBeSimulated) {
  ModelDefinition definition = model_of(wheel());
  definition.structure.parameters = {{"joint.hinge.damping", 0.0, 1.0}};
  const ModelStates states(definition);
  EXPECT_TRUE(states.of(trial_of(wheel(), 0.1), {{0.0}, {0.0}}, {0.5}));
  EXPECT_FALSE(states.of(trial_of(wheel(), 0.1), {{0.0}, {0.0}}, {5.0}));
}

}  // namespace
}  // namespace lacuna
