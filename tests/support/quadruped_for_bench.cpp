#include "support/quadruped_for_bench.h"

#include "support/robots.h"

#include <cmath>
#include <string>

namespace lacuna {

InertiaSpec cylinder_inertia(double mass, double radius, double length) {
  const double across = mass * (radius * radius / 4.0 + length * length / 12.0);
  return {.xx = across, .yy = across, .zz = mass * radius * radius / 2.0};
}

double quadruped_command(std::size_t joint, double time) {
  return 0.4 * std::sin(6.0 * time + 0.8 * static_cast<double>(joint));
}

namespace {

BodySpec leg_part(const std::string& name, const QuadrupedNumbers& numbers, const Eigen::Vector3d& top,
                  const Eigen::Vector3d& bottom) {
  BodySpec body = plain_body(name, numbers.mass, 1.0);
  body.inertia = cylinder_inertia(numbers.mass, numbers.leg_radius, numbers.leg_length);
  body.position = (top + bottom) / 2.0;
  body.orientation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), top - bottom);
  return body;
}

void add_hinge(RobotSpec& robot, const QuadrupedNumbers& numbers, const std::string& name, const std::string& parent,
               const std::string& child, const Eigen::Vector3d& anchor, const Eigen::Vector3d& axis) {
  JointSpec joint;
  joint.name = name;
  joint.parent = parent;
  joint.child = child;
  joint.anchor = anchor;
  joint.axis = axis;
  joint.lower = -numbers.stop;
  joint.upper = numbers.stop;
  robot.joints.push_back(joint);
  ActuatorSpec servo;
  servo.name = name;
  servo.joint = name;
  servo.kind = ActuatorKind::position_servo;
  servo.kp = numbers.kp;
  servo.kd = numbers.kd;
  servo.force_limit = numbers.torque;
  robot.actuators.push_back(servo);
}

void add_leg(RobotSpec& robot, const QuadrupedNumbers& numbers, int leg) {
  const auto& sign = kLegSigns[static_cast<std::size_t>(leg)];
  const std::string number = std::to_string(leg);
  const Eigen::Vector3d hip(0.0, 0.0, numbers.hip_height);
  const Eigen::Vector3d knee(sign[0], sign[1], numbers.knee_height);
  const Eigen::Vector3d below(sign[0], sign[1], 0.0);
  robot.bodies.push_back(leg_part("upper" + number, numbers, knee, hip));
  BodySpec lower = leg_part("lower" + number, numbers, knee, below);
  lower.position.z() = numbers.leg_length / 2.0 + numbers.leg_radius;
  ShapeSpec capsule;
  capsule.kind = ShapeKind::capsule;
  capsule.size = {numbers.leg_radius, numbers.leg_length, 0.0};
  lower.shapes = {capsule};
  robot.bodies.push_back(lower);
  const Eigen::Vector3d axis = Eigen::Vector3d(-sign[1], sign[0], 0.0).normalized();
  add_hinge(robot, numbers, "hip" + number, "torso", "upper" + number, hip, axis);
  add_hinge(robot, numbers, "knee" + number, "upper" + number, "lower" + number, knee, axis);
  robot.sensors.push_back(make_sensor("touch" + number, SensorKind::touch, "lower" + number));
  robot.sensors.push_back(make_sensor("angle" + number, SensorKind::joint_position, "knee" + number));
}

}  // namespace

RobotSpec quadruped_for_bench(const QuadrupedNumbers& numbers) {
  RobotSpec robot;
  robot.name = "quadruped_for_bench";
  robot.gravity = {0.0, 0.0, -numbers.gravity};
  BodySpec torso = plain_body("torso", numbers.mass, 0.4 * numbers.mass * numbers.torso_radius * numbers.torso_radius);
  torso.position = {0.0, 0.0, numbers.hip_height};
  ShapeSpec sphere;
  sphere.kind = ShapeKind::sphere;
  sphere.size = {numbers.torso_radius, 0.0, 0.0};
  torso.shapes = {sphere};
  robot.bodies.push_back(torso);
  for (int leg = 0; leg < kLegs; ++leg) add_leg(robot, numbers, leg);
  robot.sensors.push_back(make_sensor("torso", SensorKind::body_position, "torso"));
  robot.contact = {
      .ground = true, .stiffness = numbers.ground_stiffness, .damping = numbers.ground_damping, .friction = kInfinity};
  return robot;
}

}  // namespace lacuna
