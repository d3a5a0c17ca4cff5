#include "simulation/physics/stepped_by_ode.h"

#include <lacuna/physical_effect.h>

#include <cmath>
#include <string>
#include <vector>

namespace lacuna::articulation_test {
namespace {

constexpr double kSame = 1e-10;  // of a reading's largest value
constexpr int kSamples = 80;     // 0.4 s: before the trees' chaos has blown rounding up

struct Tree {
  std::string name;
  std::vector<JointKind> kinds;
  std::vector<int> parents;  ///< per joint: a body, −1 the world
};

void add_link(RobotSpec& robot, const Tree& tree, std::size_t i) {
  const auto at = static_cast<double>(i);
  BodySpec body = plain_body("body" + std::to_string(i), 0.8 + 0.3 * at, 1.0);
  body.position = Eigen::Vector3d(0.2 * at, 0.1 - 0.15 * at, -0.25 * at);
  body.orientation = Eigen::AngleAxisd(0.5 + at, Eigen::Vector3d(1.0, 2.0 - at, -1.0).normalized());
  body.com = Eigen::Vector3d(0.05, 0.02 * at, -0.08);
  body.inertia = {.xx = 0.02, .yy = 0.03, .zz = 0.015, .xy = 0.002, .xz = -0.004, .yz = 0.003};
  JointSpec joint;
  joint.name = "joint" + std::to_string(i);
  joint.kind = tree.kinds[i];
  joint.parent = tree.parents[i] < 0 ? kWorld : "body" + std::to_string(tree.parents[i]);
  joint.child = body.name;
  joint.anchor = body.position + Eigen::Vector3d(0.1, -0.05, 0.12);
  joint.axis = Eigen::Vector3d(0.3 - 0.4 * at, 1.0, 0.5 * at - 0.2).normalized();
  joint.damping = 0.05;
  joint.stiffness = 1.5;
  joint.rest = 0.1;
  joint.armature = 0.01;
  robot.bodies.push_back(body);
  robot.joints.push_back(joint);
  ActuatorSpec motor;
  motor.name = "motor" + std::to_string(i);
  motor.joint = joint.name;
  robot.actuators.push_back(motor);
  robot.sensors.push_back(make_sensor("position" + std::to_string(i), SensorKind::joint_position, joint.name));
  robot.sensors.push_back(make_sensor("velocity" + std::to_string(i), SensorKind::joint_velocity, joint.name));
}

/// Bodies and joints askew, with springs, dampers and rotors.
RobotSpec askew_tree(const Tree& tree) {
  RobotSpec robot;
  robot.name = tree.name;
  robot.gravity = Eigen::Vector3d(0.4, -0.2, -9.81);
  for (std::size_t i = 0; i < tree.kinds.size(); ++i) add_link(robot, tree, i);
  return robot;
}

/// Commands all motors at time 0.
void command_all(SimulationRun& run, double first, double next) {
  CommandSeries commands{.series = {}, .hold = Hold::zero_order};
  const auto count = static_cast<Eigen::Index>(run.structure.robot.actuators.size());
  commands.series.times = Eigen::Vector2d(0.0, 0.2);
  commands.series.samples.resize(2, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    commands.series.channels.push_back({run.structure.robot.actuators[static_cast<std::size_t>(i)].name, "1"});
    commands.series.samples.col(i) = (i % 2 == 0 ? 1.0 : -0.7) * Eigen::Vector2d(first, next);
  }
  run.test.drive = std::move(commands);
}

void start_all(SimulationRun& run, double position, double velocity) {
  std::vector<double> positions, velocities;
  for (std::size_t i = 0; i < run.structure.robot.joints.size(); ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    positions.push_back(sign * position);
    velocities.push_back(velocity * (1.0 - 0.4 * static_cast<double>(i)));
  }
  run.from(positions, velocities);
}

/// A tree of joints moves as it does where ODE steps it.
class Articulation : public testing::TestWithParam<Tree> {
 protected:
  RobotSpec robot_ = askew_tree(GetParam());
};

constexpr JointKind kHinge = JointKind::hinge, kSlider = JointKind::slider;

INSTANTIATE_TEST_SUITE_P(Trees, Articulation,
                         testing::Values(Tree{"Arm", {kHinge, kHinge}, {-1, 0}},
                                         Tree{"CartAndPole", {kSlider, kHinge}, {-1, 0}},
                                         Tree{"SliderOnLever", {kHinge, kSlider}, {-1, 0}},
                                         Tree{"Portal", {kSlider, kSlider}, {-1, 0}},
                                         Tree{"TwoRoots", {kHinge, kHinge}, {-1, -1}},
                                         Tree{"Chain", {kHinge, kHinge, kHinge, kHinge}, {-1, 0, 1, 2}},
                                         Tree{"Fork", {kSlider, kHinge, kSlider, kHinge}, {-1, 0, 0, 2}}),
                         [](const auto& test) { return test.param.name; });

TEST_P(Articulation, MovesUnderItsLaws) {
  expect_same_motion(
      robot_,
      [](SimulationRun& run) {
        start_all(run, 0.6, -2.0);
        command_all(run, 1.0, -2.0);
      },
      kSame, kSamples);
}

TEST_P(Articulation, SticksAndSlips) {
  for (JointSpec& joint : robot_.joints) joint.dry_friction = joint.kind == kSlider ? 12.0 : 2.0;
  expect_same_motion(
      robot_,
      [](SimulationRun& run) {
        start_all(run, 0.2, 1.0);
        command_all(run, 0.0, 25.0);
      },
      kSame, kSamples);
}

TEST_P(Articulation, RunsIntoItsStops) {
  for (JointSpec& joint : robot_.joints) {
    joint.lower = -0.25;
    joint.upper = 0.3;
  }
  expect_same_motion(
      robot_,
      [](SimulationRun& run) {
        start_all(run, 0.1, 1.0);
        command_all(run, 20.0, -25.0);
      },
      kSame, kSamples);
}

TEST_P(Articulation, FollowsItsServos) {
  for (ActuatorSpec& motor : robot_.actuators) {
    motor.kind = ActuatorKind::pid;
    motor.kp = 80.0;
    motor.kd = 2.0;
    motor.force_limit = 9.0;
  }
  for (JointSpec& joint : robot_.joints) joint.dry_friction = 0.3;
  expect_same_motion(
      robot_,
      [](SimulationRun& run) {
        start_all(run, 0.0, 0.3);
        command_all(run, 0.5, -0.4);
      },
      kSame, kSamples);
}

TEST_P(Articulation, SpinsFast) {
  for (JointSpec& joint : robot_.joints) joint.stiffness = 0.0;
  expect_same_motion(
      robot_,
      [](SimulationRun& run) {
        start_all(run, 0.0, 15.0);
        command_all(run, 0.4, 0.4);
      },
      kSame, kSamples / 2);
}

/// Constraints yield to what they carry, by as much as ODE has them yield.
TEST_P(Articulation, CarriesHeavyBodies) {
  constexpr double kHeavier = 50.0;
  for (BodySpec& body : robot_.bodies) {
    body.mass *= kHeavier;
    for (double* moment :
         {&body.inertia.xx, &body.inertia.yy, &body.inertia.zz, &body.inertia.xy, &body.inertia.xz, &body.inertia.yz})
      *moment *= kHeavier;
  }
  expect_same_motion(
      robot_,
      [](SimulationRun& run) {
        start_all(run, 0.3, 1.0);
        command_all(run, 10.0, -20.0);
      },
      kSame, kSamples);
}

/// Pushes and turns all bodies.
class Wind : public PhysicalEffect {
 public:
  EffectDescription describe() const override { return {}; }
  void add_loads(const StepView& view, const EffectContext&, std::span<const double>, StepLoads& loads) const override {
    for (BodyLoad& body : loads.bodies) {
      body.force += Eigen::Vector3d(3.0, -2.0 * std::sin(20.0 * view.time), 1.0);
      body.torque += Eigen::Vector3d(0.1, 0.2, -0.3 * std::cos(20.0 * view.time));
    }
  }
};

TEST_P(Articulation, IsPushedAtItsBodies) {
  const Wind wind;
  expect_same_motion(
      robot_,
      [&](SimulationRun& run) {
        start_all(run, 0.3, 0.5);
        run.place(wind, ElementKind::body, {0}, {});
      },
      kSame, kSamples);
}

}  // namespace
}  // namespace lacuna::articulation_test
