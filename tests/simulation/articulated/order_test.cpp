#include "support/convergence.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace lacuna::articulated_order_test {
namespace {

/// A motion whose order is asked for: what happens up to `end`, in `steps` steps at first, from starts that differ by a
/// scale, so that events come at different shares of a step.
struct Motion {
  std::string name;
  std::function<SimulationRun(double step, double scale)> run;
  double end = 1.0;
  int steps = 100;
  int starts = 5;
};

std::ostream& operator<<(std::ostream& out, const Motion& motion) { return out << motion.name; }

BodySpec link(const std::string& name, const Eigen::Vector3d& position) {
  BodySpec body;
  body.name = name;
  body.mass = 1.0;
  body.inertia = {0.05, 0.05, 0.02};
  body.position = position;
  return body;
}

/// Links of 0.5 m that hang on hinges, about y and x in turn where they are `twisted`.
RobotSpec chain(int links, bool twisted = false) {
  RobotSpec robot;
  robot.name = "chain";
  for (int i = 0; i < links; ++i) {
    const std::string name = "link" + std::to_string(i);
    robot.bodies.push_back(link(name, {0.0, 0.0, -0.5 * i - 0.25}));
    JointSpec joint;
    joint.name = "joint" + std::to_string(i);
    joint.parent = i == 0 ? kWorld : robot.bodies[static_cast<std::size_t>(i) - 1].name;
    joint.child = name;
    joint.anchor = {0.0, 0.0, -0.5 * i};
    joint.axis = twisted && i % 2 == 1 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    robot.joints.push_back(joint);
    robot.sensors.push_back(make_sensor("position" + std::to_string(i), SensorKind::joint_position, joint.name));
    robot.sensors.push_back(make_sensor("velocity" + std::to_string(i), SensorKind::joint_velocity, joint.name));
  }
  return robot;
}

ActuatorSpec actuator(ActuatorKind kind) {
  ActuatorSpec actuator;
  actuator.name = "motor";
  actuator.joint = "joint0";
  actuator.kind = kind;
  return actuator;
}

SimulationRun of(const RobotSpec& robot, double step, const std::string& engine) {
  SimulationRun run(robot, step);
  run.engine.engine = engine;
  return run;
}

using Change = std::function<void(RobotSpec&)>;

Motion hanging(const std::string& name, int links, double end, int steps, const Change& change,
               const std::string& engine, int starts = 5) {
  RobotSpec robot = chain(links, links > 2);
  change(robot);
  const auto run = [robot, links, engine](double step, double scale) {
    SimulationRun made = of(robot, step, engine);
    std::vector<double> start;
    for (int i = 0; i < links; ++i) start.push_back(1.2 * scale / (1.0 + i));
    made.from(start, std::vector<double>(start.size(), 0.0));
    if (!robot.actuators.empty()) made.command("motor", robot.actuators[0].kind == ActuatorKind::force ? 1.0 : 0.8);
    return made;
  };
  return {name, run, end, steps, starts};
}

const Change kNothing = [](RobotSpec&) {};

std::vector<Motion> motions(const std::string& engine) {
  const auto all_joints = [](const std::function<void(JointSpec&)>& change) {
    return [change](RobotSpec& robot) {
      for (JointSpec& joint : robot.joints) change(joint);
    };
  };
  const auto driven = [](const ActuatorSpec& motor) {
    return [motor](RobotSpec& robot) { robot.actuators = {motor}; };
  };
  ActuatorSpec servo = actuator(ActuatorKind::position_servo);
  servo.kp = 30.0;
  servo.kd = 1.0;
  servo.force_limit = 3.0;
  ActuatorSpec pid = actuator(ActuatorKind::pid);
  pid.kp = 30.0;
  pid.ki = 20.0;
  pid.kd = 1.0;
  ActuatorSpec gear = actuator(ActuatorKind::force);
  gear.transmission = {.ratio = 10.0, .rotor_inertia = 1e-3, .stiffness = 60.0, .damping = 0.1, .gap = 0.0};
  ActuatorSpec play = gear;
  play.transmission.damping = 1.0;
  play.transmission.gap = 0.05;
  return {
      hanging("Pendulum", 1, 3.0, 100, kNothing, engine),
      hanging("DoublePendulum", 2, 2.0, 200, kNothing, engine),
      hanging("Spring", 1, 2.0, 200, all_joints([](JointSpec& joint) { joint.stiffness = 40.0; }), engine),
      hanging("DampedSpring", 1, 2.0, 200, all_joints([](JointSpec& joint) {
                joint.stiffness = 40.0;
                joint.damping = 0.5;
              }),
              engine),
      hanging("ServoAtItsLimit", 1, 2.0, 200, driven(servo), engine, 24),  // a kink in the force
      hanging("Pid", 1, 2.0, 200, driven(pid), engine),
      hanging("CompliantGear", 1, 2.0, 400, driven(gear), engine),
      hanging("GearWithPlay", 1, 2.0, 200, driven(play), engine, 12),  // the flanks' damping jumps
      hanging("SevenJointArm", 7, 1.0, 200, all_joints([](JointSpec& joint) { joint.damping = 0.02; }), engine),
      hanging("FrictionReversing", 1, 4.0, 200, all_joints([](JointSpec& joint) { joint.dry_friction = 0.1; }), engine),
      hanging("FrictionInTwoJoints", 2, 2.0, 400, all_joints([](JointSpec& joint) { joint.dry_friction = 0.1; }),
              engine),
      hanging("Stop", 1, 2.0, 200, all_joints([](JointSpec& joint) { joint.lower = -0.5; }), engine)};
}

constexpr int kHalvings = 6;
constexpr int kReadings = 20;  ///< of each run; `steps` is a multiple of it

TimeSeries::Samples readings_of(const Motion& motion, int halving) {
  const double step = motion.end / std::ldexp(motion.steps, halving);
  TimeSeries::Samples all;
  for (int start = 0; start < motion.starts; ++start) {
    const double scale = 0.8 + 0.3 * start / motion.starts;
    const TimeSeries::Samples one = motion.run(step, scale).run(evenly_spaced(motion.end, kReadings)).readings.samples;
    all.conservativeResize(all.rows() + one.rows(), one.cols());
    all.bottomRows(one.rows()) = one;
  }
  return all;
}

Convergence convergence_of(const Motion& motion) {
  return converge([&](int halving) { return readings_of(motion, halving); }, kHalvings);
}

class Articulated : public testing::TestWithParam<Motion> {};
INSTANTIATE_TEST_SUITE_P(Motions, Articulated, testing::ValuesIn(motions("articulated")),
                         [](const auto& test) { return test.param.name; });

TEST_P(Articulated, IsOfSecondOrder) {
  const Convergence found = convergence_of(GetParam());
  EXPECT_GT(found.order, 1.8) << to_string(found);
  EXPECT_LT(found.order, 2.2) << to_string(found);
}

class Ode : public testing::TestWithParam<Motion> {};
INSTANTIATE_TEST_SUITE_P(Motions, Ode, testing::ValuesIn(motions("ode")),
                         [](const auto& test) { return test.param.name; });

TEST_P(Ode, IsOfFirstOrder) {
  const Convergence found = convergence_of(GetParam());
  EXPECT_LT(found.order, 1.3) << to_string(found);
}

}  // namespace
}  // namespace lacuna::articulated_order_test
