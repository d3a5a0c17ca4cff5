#include "dirty/robot_value.h"

#include <stdexcept>

namespace hidden_effects::dirty {

double& RobotValue::in(PlantSpec& spec) const {
  const auto e = static_cast<std::size_t>(element);
  switch (quantity) {
    case Quantity::mass: return spec.bodies[e].mass;
    case Quantity::lever: return spec.bodies[e].com.y();
    case Quantity::inertia: return spec.bodies[e].inertia;
    case Quantity::armature: return spec.joints[e].armature;
    case Quantity::damping: return spec.joints[e].damping;
    case Quantity::stiffness: return spec.joints[e].stiffness;
    case Quantity::rest: return spec.joints[e].rest;
    case Quantity::gain: return spec.drives[e].gain;
    case Quantity::kp: return spec.drives[e].kp;
    case Quantity::kd: return spec.drives[e].kd;
    case Quantity::torque_constant: return spec.drives[e].torque_constant;
    case Quantity::scale: return spec.sensors[e].scale;
  }
  throw std::logic_error("a value of no quantity");
}

double RobotValue::in(const PlantSpec& spec) const {
  PlantSpec copy = spec;
  return in(copy);
}

std::string RobotValue::address(const PlantSpec& spec) const {
  const auto e = static_cast<std::size_t>(element);
  const auto of_body = [&](const char* key) { return "body." + spec.bodies[e].name + key; };
  const auto of_joint = [&](const char* key) { return "joint." + spec.joints[e].name + key; };
  const auto of_drive = [&](const char* key) { return "actuator." + spec.drives[e].name + key; };
  switch (quantity) {
    case Quantity::mass: return of_body(".mass");
    case Quantity::lever: return of_body(".com.z");
    case Quantity::inertia: return of_body(".inertia.yy");
    case Quantity::armature: return of_joint(".armature");
    case Quantity::damping: return of_joint(".damping");
    case Quantity::stiffness: return of_joint(".stiffness");
    case Quantity::rest: return of_joint(".rest");
    case Quantity::gain: return of_drive(".gain");
    case Quantity::kp: return of_drive(".kp");
    case Quantity::kd: return of_drive(".kd");
    case Quantity::torque_constant: return of_drive(".motor.torque_constant");
    case Quantity::scale: return "sensor." + spec.sensors[e].name + ".scale";
  }
  throw std::logic_error("a value of no quantity");
}

int RobotValue::joint(const PlantSpec& spec) const {
  const auto e = static_cast<std::size_t>(element);
  switch (quantity) {
    case Quantity::gain:
    case Quantity::kp:
    case Quantity::kd:
    case Quantity::torque_constant: return spec.drives[e].joint;
    case Quantity::scale: return spec.sensors[e].joint;
    default: return element;
  }
}

}  // namespace hidden_effects::dirty
