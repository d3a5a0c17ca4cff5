#include "simulation/engine/support.h"

#include <cmath>

namespace lacuna::testing {
namespace {

RobotSpec one_joint(const std::string& body, const std::string& joint, JointKind kind) {
  RobotSpec robot;
  robot.bodies.emplace_back().name = body;
  JointSpec& spec = robot.joints.emplace_back();
  spec.name = joint;
  spec.kind = kind;
  spec.child = body;
  ActuatorSpec& motor = robot.actuators.emplace_back();
  motor.name = "motor";
  motor.joint = joint;
  return robot;
}

}  // namespace

RobotSpec pendulum() {
  RobotSpec robot = one_joint("rod", "hinge", JointKind::hinge);
  robot.name = "pendulum";
  robot.bodies[0].position = {0.0, 0.0, -0.5};
  robot.bodies[0].inertia = {.xx = 1.0 / 12.0, .yy = 1.0 / 12.0, .zz = 1e-3};
  robot.joints[0].axis = {0.0, 1.0, 0.0};
  robot.sensors = {sensor("angle", SensorKind::joint_position, "hinge"),
                   sensor("rate", SensorKind::joint_velocity, "hinge"),
                   sensor("torque", SensorKind::joint_force, "hinge")};
  return robot;
}

RobotSpec cart() {
  RobotSpec robot = one_joint("cart", "rail", JointKind::slider);
  robot.name = "cart";
  robot.bodies[0].mass = 2.0;
  robot.joints[0].axis = {1.0, 0.0, 0.0};
  robot.sensors = {sensor("place", SensorKind::joint_position, "rail"),
                   sensor("speed", SensorKind::joint_velocity, "rail"),
                   sensor("force", SensorKind::joint_force, "rail")};
  return robot;
}

SensorSpec sensor(const std::string& name, SensorKind kind, const std::string& element) {
  SensorSpec spec;
  spec.name = name;
  spec.kind = kind;
  spec.element = element;
  return spec;
}

EngineSettings step_of(double seconds) {
  EngineSettings settings;
  settings.step = seconds;
  return settings;
}

Test series(const std::string& channel, std::vector<double> times, std::vector<double> values, Hold hold) {
  CommandSeries commands;
  commands.hold = hold;
  commands.series.channels = {{channel, "1"}};
  const auto count = static_cast<Eigen::Index>(times.size());
  commands.series.times = Eigen::Map<Eigen::VectorXd>(times.data(), count);
  commands.series.samples = Eigen::Map<Eigen::VectorXd>(values.data(), count);
  Test test;
  test.drive = std::move(commands);
  return test;
}

Test constant(const std::string& channel, double value) { return series(channel, {0.0}, {value}); }

std::vector<double> grid(double begin, double end, double step) {
  std::vector<double> times;
  const auto count = static_cast<int>(std::lround((end - begin) / step));
  for (int i = 0; i <= count; ++i) times.push_back(begin + i * step);
  return times;
}

Rig::Rig(ModelStructure structure, const EngineSettings& settings)
    : model(compile(structure, settings)), workspace(model->make_workspace()) {}

Rig::Rig(RobotSpec robot, const EngineSettings& settings)
    : Rig(ModelStructure{.robot = std::move(robot), .effects = {}, .parameters = {}}, settings) {}

const SimulationResult& Rig::run(const Test& test, const std::vector<double>& times,
                                 const std::vector<double>& parameters) {
  options.output_times = times;
  options.end_time = times.back();
  model->simulate(parameters, test, options, *workspace, result);
  return result;
}

}  // namespace lacuna::testing
