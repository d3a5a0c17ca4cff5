#include "support/robots.h"

namespace lacuna {

BodySpec plain_body(const std::string& name, double mass, double inertia) {
  BodySpec body;
  body.name = name;
  body.mass = mass;
  body.inertia = {.xx = inertia, .yy = inertia, .zz = inertia};
  return body;
}

SensorSpec make_sensor(const std::string& name, SensorKind kind, const std::string& element) {
  SensorSpec sensor;
  sensor.name = name;
  sensor.kind = kind;
  sensor.element = element;
  return sensor;
}

namespace {

void add_joint_instruments(RobotSpec& robot) {
  robot.sensors = {make_sensor("position", SensorKind::joint_position, "joint"),
                   make_sensor("velocity", SensorKind::joint_velocity, "joint"),
                   make_sensor("force", SensorKind::joint_force, "joint")};
  ActuatorSpec motor;
  motor.name = "motor";
  motor.joint = "joint";
  robot.actuators = {motor};
}

JointSpec make_joint(const std::string& name, JointKind kind, const std::string& parent, const std::string& child) {
  JointSpec joint;
  joint.name = name;
  joint.kind = kind;
  joint.parent = parent;
  joint.child = child;
  return joint;
}

}  // namespace

RobotSpec one_joint(JointKind kind, double inertia, const Eigen::Vector3d& axis) {
  RobotSpec robot;
  robot.name = "one_joint";
  robot.gravity.setZero();
  robot.bodies = {plain_body("body", kind == JointKind::slider ? inertia : 1.0, inertia)};
  robot.joints = {make_joint("joint", kind, kWorld, "body")};
  robot.joints[0].axis = axis;
  add_joint_instruments(robot);
  return robot;
}

RobotSpec pendulum(double mass, double length, double inertia) {
  RobotSpec robot;
  robot.name = "pendulum";
  robot.gravity = {0.0, 0.0, -kGravity};
  robot.bodies = {plain_body("body", mass, inertia)};
  robot.bodies[0].position = {0.0, 0.0, -length};
  robot.joints = {make_joint("joint", JointKind::hinge, kWorld, "body")};
  add_joint_instruments(robot);
  return robot;
}

double pendulum_rate(double mass, double length, double inertia) {
  return mass * kGravity * length / (inertia + mass * length * length);
}

RobotSpec double_pendulum(double mass, double length, double inertia) {
  RobotSpec robot;
  robot.name = "double_pendulum";
  robot.gravity = {0.0, 0.0, -kGravity};
  robot.bodies = {plain_body("first", mass, inertia), plain_body("second", mass, inertia)};
  robot.bodies[0].position = {0.0, 0.0, -length};
  robot.bodies[1].position = {0.0, 0.0, -2.0 * length};
  robot.joints = {make_joint("upper", JointKind::hinge, kWorld, "first"),
                  make_joint("lower", JointKind::hinge, "first", "second")};
  robot.joints[1].anchor = {0.0, 0.0, -length};
  robot.sensors = {
      make_sensor("q1", SensorKind::joint_position, "upper"), make_sensor("v1", SensorKind::joint_velocity, "upper"),
      make_sensor("q2", SensorKind::joint_position, "lower"), make_sensor("v2", SensorKind::joint_velocity, "lower")};
  return robot;
}

RobotSpec driven_chain(std::size_t links) {
  constexpr double kLink = 0.2;  // m
  RobotSpec robot;
  robot.name = "chain";
  robot.gravity = {0.0, 0.0, -kGravity};
  for (std::size_t i = 1; i <= links; ++i) {
    const std::string number = std::to_string(i);
    BodySpec link = plain_body("link" + number, 0.5, 0.005);
    link.position = {0.0, 0.0, -kLink * static_cast<double>(i - 1)};
    link.com = {0.0, 0.0, -0.5 * kLink};
    JointSpec hinge = make_joint("j" + number, JointKind::hinge, i == 1 ? kWorld : robot.bodies.back().name, link.name);
    hinge.anchor = link.position;
    ActuatorSpec motor;
    motor.name = "m" + number;
    motor.joint = hinge.name;
    robot.sensors.push_back(make_sensor("q" + number, SensorKind::joint_position, hinge.name));
    robot.bodies.push_back(std::move(link));
    robot.joints.push_back(std::move(hinge));
    robot.actuators.push_back(std::move(motor));
  }
  return robot;
}

RobotSpec floating_body(double mass, const InertiaSpec& inertia) {
  RobotSpec robot;
  robot.name = "floating_body";
  robot.gravity = {0.0, 0.0, -kGravity};
  robot.bodies = {plain_body("body", mass, 1.0)};
  robot.bodies[0].inertia = inertia;
  robot.sensors = {make_sensor("position", SensorKind::body_position, "body"),
                   make_sensor("velocity", SensorKind::body_velocity, "body"),
                   make_sensor("orientation", SensorKind::body_orientation, "body"),
                   make_sensor("spin", SensorKind::body_angular_velocity, "body")};
  return robot;
}

}  // namespace lacuna
