#include "effects/joint_compliance.h"

namespace lacuna {

EffectDescription JointCompliance::describe() const {
  return {.summary = "An elastic transmission between motor and joint",
          .equation = "tau = k*(rotor - q) + c*(d rotor/dt - v)",
          .literature = "M. W. Spong, J. Dyn. Sys., Meas., Control 109 (1987) 310",
          .regime = "fast changes of the load",
          .look_alikes = {"backlash"},
          .placements = {ElementKind::actuator},
          .parameters = {{"stiffness", "N*m/rad", 1e4, 1e-3, 1e9, Scale::logarithmic, "Stiffness at the joint"},
                         {"damping", "N*m*s/rad", 0.0, 0.0, 1e6, Scale::linear, "Damping at the joint"}}};
}

void JointCompliance::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements) {
    TransmissionSpec& transmission = robot.actuators[static_cast<std::size_t>(actuator)].transmission;
    transmission.stiffness = context.parameters[0];
    transmission.damping += context.parameters[1];
  }
}

}  // namespace lacuna
