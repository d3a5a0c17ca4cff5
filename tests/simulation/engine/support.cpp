#include "simulation/engine/support.h"

#include "support/sanitizers.h"

#include <cmath>

#if LACUNA_WATCHED
// An exception out of a step of ODE's loses the job (80 bytes) that was being done.
extern "C" const char* __lsan_default_suppressions() { return "leak:PreallocateJobInfos\n"; }  // NOLINT
#endif

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

BodySpec block(const std::string& name, double mass, const Eigen::Vector3d& position, const Eigen::Vector3d& size) {
  BodySpec body;
  body.name = name;
  body.mass = mass;
  body.position = position;
  const Eigen::Vector3d squares = size.cwiseProduct(size) * mass / 12.0;
  body.inertia = {.xx = squares.y() + squares.z(), .yy = squares.x() + squares.z(), .zz = squares.x() + squares.y()};
  ShapeSpec& shape = body.shapes.emplace_back();
  shape.size = size;
  return body;
}

JointSpec joint(const std::string& name, JointKind kind, const std::string& parent, const std::string& child,
                const Eigen::Vector3d& anchor, const Eigen::Vector3d& axis) {
  JointSpec spec;
  spec.name = name;
  spec.kind = kind;
  spec.parent = parent;
  spec.child = child;
  spec.anchor = anchor;
  spec.axis = axis;
  return spec;
}

void add_everything_joints(RobotSpec& robot) {
  robot.joints = {joint("shoulder", JointKind::hinge, "box", "arm", {0.0, 0.0, 0.25}, {0.0, 1.0, 0.0}),
                  joint("rail", JointKind::slider, "box", "sled", {0.0, 0.3, 0.15}, {1.0, 0.0, 0.0}),
                  joint("axle", JointKind::hinge, "box", "wheel", {0.0, -0.3, 0.15}, {0.0, 1.0, 0.0}),
                  joint("cardan", JointKind::universal, "arm", "hand", {0.0, 0.0, 0.65}, {1.0, 0.0, 0.0}),
                  joint("eye", JointKind::ball, "box", "eye", {0.3, 0.0, 0.2}, {0.0, 0.0, 1.0})};
  robot.joints[3].axis2 = {0.0, 1.0, 0.0};
  robot.joints[0].lower = -0.4;
  robot.joints[0].upper = 0.4;
  robot.joints[1].dry_friction = 0.3;
  robot.joints[1].upper = 0.05;
  robot.joints[2].damping = 0.01;
  robot.joints[3].stiffness = 2.0;
  robot.joints[3].damping = 0.02;
  robot.joints[3].armature = 1e-3;
  robot.joints[4].damping = 0.01;
}

void add_everything_actuators(RobotSpec& robot) {
  ActuatorSpec arm, sled, wheel;
  arm.name = "arm_servo", arm.joint = "shoulder", arm.kind = ActuatorKind::position_servo;
  arm.kp = 60.0, arm.kd = 1.0, arm.force_limit = 8.0, arm.delay = 0.0123;
  sled.name = "sled_pid", sled.joint = "rail", sled.kind = ActuatorKind::pid;
  sled.kp = 100.0, sled.ki = 300.0, sled.kd = 5.0, sled.force_limit = 20.0;
  wheel.name = "wheel_motor", wheel.joint = "axle";
  wheel.transmission = {.ratio = 10.0, .rotor_inertia = 1e-5, .stiffness = 50.0, .damping = 0.05, .gap = 0.02};
  robot.actuators = {arm, sled, wheel};
}

void add_everything_sensors(RobotSpec& robot) {
  robot.sensors = {sensor("shoulder_angle", SensorKind::joint_position, "shoulder"),
                   sensor("sled_speed", SensorKind::joint_velocity, "rail"),
                   sensor("axle_torque", SensorKind::joint_force, "axle"),
                   sensor("cardan_angles", SensorKind::joint_position, "cardan"),
                   sensor("eye_rotation", SensorKind::joint_position, "eye"),
                   sensor("box_touch", SensorKind::touch, "box"),
                   sensor("box_place", SensorKind::body_position, "box"),
                   sensor("hand_velocity", SensorKind::body_velocity, "hand"),
                   sensor("eye_orientation", SensorKind::body_orientation, "eye"),
                   sensor("wheel_rate", SensorKind::body_angular_velocity, "wheel"),
                   sensor("range", SensorKind::beacon_range, "hand"),
                   sensor("ground_force", SensorKind::contact_force, "box"),
                   sensor("hand_acceleration", SensorKind::accelerometer, "hand")};
  robot.sensors[0].delay = 0.0071;
  robot.sensors[5].delay = 0.02;
  robot.sensors[7].delay = 0.0005;
  robot.sensors[10].beacon = {1.0, 1.0, 0.0};
  robot.sensors[12].at = {0.02, 0.0, 0.1};
}

}  // namespace

RobotSpec everything() {
  RobotSpec robot;
  robot.name = "everything";
  robot.bodies = {
      block("box", 3.0, {0.0, 0.0, 0.1}, {0.6, 0.6, 0.2}),   block("arm", 0.5, {0.0, 0.0, 0.45}, {0.05, 0.05, 0.4}),
      block("sled", 0.4, {0.0, 0.3, 0.25}, {0.1, 0.1, 0.1}), block("wheel", 0.3, {0.0, -0.36, 0.15}, {0.1, 0.05, 0.1}),
      block("hand", 0.2, {0.0, 0.0, 0.75}, {0.1, 0.1, 0.1}), block("eye", 0.1, {0.3, 0.0, 0.25}, {0.05, 0.05, 0.05})};
  robot.bodies[1].com = {0.01, 0.0, 0.02};
  add_everything_joints(robot);
  add_everything_actuators(robot);
  add_everything_sensors(robot);
  robot.contact = {.ground = true, .stiffness = 2e4, .damping = 300.0, .friction = 0.3, .slope = 0.05};
  return robot;
}

RobotSpec everything_in_the_air() {
  RobotSpec robot = everything();
  robot.contact.ground = false;
  for (BodySpec& body : robot.bodies) body.shapes.clear();
  return robot;
}

RobotSpec everything_for(const std::string& engine) {
  return engine == "articulated" ? everything_in_the_air() : everything();
}

Test shake() {
  CommandSeries commands;
  commands.hold = Hold::first_order;
  commands.series.channels = {{"arm_servo", "rad"}, {"sled_pid", "m"}, {"wheel_motor", "N*m"}};
  constexpr int kSamples = 200;
  constexpr double kInterval = 0.0097;
  commands.series.times.resize(kSamples);
  commands.series.samples.resize(kSamples, 3);
  for (int i = 0; i < kSamples; ++i) {
    const double t = i * kInterval;
    commands.series.times[i] = t;
    commands.series.samples.row(i) << 0.6 * std::sin(9.0 * t), 0.1 * std::cos(7.0 * t), 0.2 * std::sin(23.0 * t);
  }
  Test test;
  test.drive = std::move(commands);
  return test;
}

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

Rig::Rig(const ModelStructure& structure, const EngineSettings& settings)
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
