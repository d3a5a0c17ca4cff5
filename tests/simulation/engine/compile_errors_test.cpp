#include "simulation/engine/effects.h"
#include "simulation/engine/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna::testing {
namespace {

using ::testing::HasSubstr;

std::string complaint(const ModelStructure& structure, const EngineSettings& settings = {}) {
  try {
    compile(structure, settings);
  } catch (const Error& error) {
    return error.what();
  }
  return "compiled";
}

std::string complaint(const RobotSpec& robot) {
  return complaint(ModelStructure{.robot = robot, .effects = {}, .parameters = {}});
}

TEST(CompileErrors, SoundRobotsCompile) {
  EXPECT_EQ(complaint(pendulum()), "compiled");
  EXPECT_EQ(complaint(everything()), "compiled");
}

TEST(CompileErrors, UnknownEngine) {
  EngineSettings settings;
  settings.engine = "odd";
  EXPECT_THAT(complaint({.robot = pendulum(), .effects = {}, .parameters = {}}, settings),
              HasSubstr("no engine \"odd\" (did you mean \"ode\"?)"));
}

TEST(CompileErrors, SettingsThatCannotRun) {
  EngineSettings settings;
  settings.step = 0.0;
  settings.substeps = -1;
  settings.joint_erp = 1.5;
  settings.control_period = -1.0;
  const std::string text = complaint({.robot = pendulum(), .effects = {}, .parameters = {}}, settings);
  for (const char* key : {"engine.step", "engine.substeps", "engine.joint_erp", "engine.control_period"})
    EXPECT_THAT(text, HasSubstr(key));
}

TEST(CompileErrors, JointsThatNameUnknownBodies) {
  RobotSpec robot = pendulum();
  robot.joints[0].child = "rode";
  EXPECT_THAT(complaint(robot), HasSubstr("child \"rode\" is not a body of the robot (did you mean \"rod\"?)"));
  robot = pendulum();
  robot.joints[0].parent = "worl";
  EXPECT_THAT(complaint(robot), HasSubstr("did you mean \"world\"?"));
}

TEST(CompileErrors, BodyThatIsTheChildOfTwoJoints) {
  RobotSpec robot = pendulum();
  robot.joints.push_back(robot.joints[0]);
  robot.joints[1].name = "second";
  EXPECT_THAT(complaint(robot), HasSubstr("body \"rod\" is the child of two joints, \"hinge\" and \"second\""));
}

TEST(CompileErrors, CycleOfJoints) {
  RobotSpec robot = pendulum();
  robot.bodies.push_back(robot.bodies[0]);
  robot.bodies[1].name = "other";
  robot.joints.push_back(robot.joints[0]);
  robot.joints[0].parent = "other";
  robot.joints[1].name = "back";
  robot.joints[1].parent = "rod";
  robot.joints[1].child = "other";
  EXPECT_THAT(complaint(robot), HasSubstr("cycle"));
}

TEST(CompileErrors, RepeatedNames) {
  RobotSpec robot = pendulum();
  robot.sensors.push_back(robot.sensors[0]);
  robot.actuators.push_back(robot.actuators[0]);
  EXPECT_THAT(complaint(robot), HasSubstr("two sensors of the robot have the name \"angle\""));
  EXPECT_THAT(complaint(robot), HasSubstr("two actuators of the robot have the name \"motor\""));
}

TEST(CompileErrors, ActuatorsOnJointsWithoutAnAxis) {
  for (const JointKind kind : {JointKind::ball, JointKind::fixed}) {
    RobotSpec robot = pendulum();
    robot.joints[0].kind = kind;
    robot.sensors.clear();
    EXPECT_THAT(complaint(robot), HasSubstr("actuator \"motor\": its joint \"hinge\" is a ball, free or fixed joint"));
  }
}

TEST(CompileErrors, MassesAndInertias) {
  RobotSpec robot = pendulum();
  robot.bodies[0].mass = 0.0;
  EXPECT_THAT(complaint(robot), HasSubstr("its mass is 0 kg"));
  robot.bodies[0].mass = 1e308;
  EXPECT_THAT(complaint(robot), HasSubstr("its mass is 1e+308 kg, it must be positive and at most 1e+12 kg"));
  robot = pendulum();
  robot.bodies[0].inertia.xy = 0.5;
  EXPECT_THAT(complaint(robot), HasSubstr("not positive definite"));
  robot.bodies[0].inertia.xy = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(complaint(robot), HasSubstr("not positive definite"));
}

TEST(CompileErrors, SensorsOnUnknownElements) {
  RobotSpec robot = pendulum();
  robot.sensors[0].element = "hnge";
  robot.sensors[1].kind = SensorKind::touch;
  const std::string text = complaint(robot);
  EXPECT_THAT(text, HasSubstr("\"hnge\", which is not a joint of the robot (did you mean \"hinge\"?)"));
  EXPECT_THAT(text, HasSubstr("\"hinge\", which is not a body of the robot"));
}

TEST(CompileErrors, AxesStopsShapesAndGaps) {
  RobotSpec robot = everything();
  robot.joints[0].axis = {0.0, 2.0, 0.0};
  robot.joints[3].axis2 = robot.joints[3].axis;
  robot.joints[1].lower = 1.0;
  robot.bodies[0].shapes[0].size.z() = 0.0;
  robot.actuators[2].transmission.stiffness = kInfinity;
  const std::string text = complaint(robot);
  for (const char* part : {"joint \"shoulder\": its axis is not a unit vector", "joint \"cardan\": its axis2",
                           "joint \"rail\": its lower stop is above its upper stop", "body \"box\": a shape's sizes",
                           "actuator \"wheel_motor\": its transmission has a gap but infinite stiffness"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(CompileErrors, ParameterAddresses) {
  ModelStructure structure{.robot = pendulum(), .effects = {}, .parameters = {{"body.rod.mas", 0.0, 1.0}}};
  EXPECT_THAT(complaint(structure),
              HasSubstr("\"body.rod.mas\" is not a value of the robot or of its effects (did you mean "
                        "\"body.rod.mass\"?)"));
  structure.parameters = {{"body.rod.mass", 2.0, 1.0}};
  EXPECT_THAT(complaint(structure), HasSubstr("its lower bound above its upper bound"));
  structure.parameters = {{"body.rod.mass", -1.0, 1.0}};
  EXPECT_THAT(complaint(structure), HasSubstr("beyond the"));
  structure.parameters = {{"body.rod.mass", 0.5, 1.0}, {"body.rod.mass", 0.5, 1.0}};
  EXPECT_THAT(complaint(structure), HasSubstr("listed twice"));
  structure.parameters = {{"sensor.angle.delay", 0.0, kInfinity}};
  EXPECT_THAT(complaint(structure), HasSubstr("finite upper bound"));
}

TEST(CompileErrors, EffectsThatDoNotFit) {
  const ExtraMass extra;
  const Lag lag(true);
  ModelStructure structure{
      .robot = pendulum(),
      .effects = {place("few", extra, ElementKind::body, {0}), place("far", extra, ElementKind::body, {3}, {0.0}),
                  place("wrong", lag, ElementKind::joint, {0}, {0.0}),
                  place("few", extra, ElementKind::body, {0}, {0.0})},
      .parameters = {}};
  structure.effects.push_back(structure.effects[1]);
  structure.effects.back().effect = nullptr;
  structure.effects.back().id = "none";
  const std::string text = complaint(structure);
  EXPECT_THAT(text, HasSubstr("it has 0 values for 1 declared parameters"));
  EXPECT_THAT(text, HasSubstr("\"far\" (far): it is placed on an element that the robot does not have"));
  EXPECT_THAT(text, HasSubstr("\"wrong\" (wrong): it changes commands and must be placed on actuators"));
  EXPECT_THAT(text, HasSubstr("two effects have the id \"few\""));
  EXPECT_THAT(text, HasSubstr("it has no component"));
}

TEST(CompileErrors, ArgumentsOfASimulation) {
  Rig rig(pendulum());
  const lacuna::Test good = constant("motor", 0.0);
  EXPECT_THROW(rig.run(constant("moter", 0.0), {0.1}), Error);
  EXPECT_THROW(rig.run(good, {0.1}, {1.0}), Error);
  EXPECT_THROW(rig.run(good, {0.2, 0.1}), Error);
  EXPECT_THROW(rig.run(good, {-0.1, 0.1}), Error);
  rig.options.start.positions = {0.0, 0.0};
  EXPECT_THROW(rig.run(good, {0.1}), Error);
  rig.options.start.positions = {};
  Rig other(pendulum());
  EXPECT_THROW(rig.model->simulate({}, good, rig.options, *other.workspace, rig.result), Error);
  EXPECT_THROW(rig.run(lacuna::Test{.drive = std::shared_ptr<const Controller>(), .duration = 1.0, .start = {}}, {0.1}),
               Error);
}

}  // namespace
}  // namespace lacuna::testing
