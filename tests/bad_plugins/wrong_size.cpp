#include "bad_effect.h"

#include <limits>

namespace {

class NegativeState : public bad::Effect {
 public:
  int state_size(const lacuna::EffectContext&) const override { return -3; }
};

class EndlessState : public bad::Effect {
 public:
  int state_size(const lacuna::EffectContext&) const override { return std::numeric_limits<int>::max(); }
};

class RemovesBodies : public bad::Effect {
 public:
  void amend(lacuna::RobotSpec& robot, const lacuna::EffectContext&) const override { robot.bodies.clear(); }
};

/// Two joints want the same child, an actuator drives a joint that is not there.
class Robot : public lacuna::RobotDefinition {
 public:
  std::string summary() const override { return "Broken on purpose"; }
  lacuna::RobotSpec build(const lacuna::RobotRequest&) const override {
    lacuna::RobotSpec robot;
    robot.bodies.resize(1);
    robot.bodies[0].name = "arm";
    robot.joints.resize(2);
    robot.joints[0].name = "one";
    robot.joints[1].name = "two";
    for (lacuna::JointSpec& joint : robot.joints) joint.child = "arm";
    robot.actuators.resize(1);
    robot.actuators[0].name = "motor";
    robot.actuators[0].joint = "three";
    return robot;
  }
};

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, NegativeState>("negative_state"),
              lacuna::component<lacuna::PhysicalEffect, EndlessState>("endless_state"),
              lacuna::component<lacuna::PhysicalEffect, RemovesBodies>("removes_bodies"),
              lacuna::component<lacuna::RobotDefinition, Robot>("inconsistent_robot"))
