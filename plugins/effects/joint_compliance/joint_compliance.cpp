#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// An elastic transmission between an actuator's rotor and its joint.
class JointCompliance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

namespace {

enum Parameter : std::size_t { kStiffness, kDamping };

}  // namespace

EffectDescription JointCompliance::describe() const {
  return {.summary = "An elastic transmission between an actuator's rotor and its joint",
          .equation = "tau = stiffness*(rotor - q) + damping*(d rotor/dt - v)",
          .literature = "M. W. Spong, J. Dynamic Systems, Measurement, and Control 109 (1987) 310-319",
          .regime = "quick changes of the load; the joint oscillates",
          .look_alikes = {"backlash", "link_flexibility", "base_compliance"},
          .placements = {ElementKind::actuator},
          .parameters = {{"stiffness", "{force}/{position}", 10000.0, 0.001, 1e9, Scale::logarithmic,
                          "Stiffness, at the joint"},
                         {"damping", "{force}*s/{position}", 0.0, 0.0, 1e6, Scale::linear, "Damping, at the joint"}},
          .neutral = {1e9, 0.0}};
}

void JointCompliance::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements) {
    TransmissionSpec& transmission = robot.actuators[static_cast<std::size_t>(actuator)].transmission;
    const double stiffness = context.parameters[kStiffness];
    transmission.stiffness = std::isfinite(transmission.stiffness)
                                 ? stiffness * transmission.stiffness / (stiffness + transmission.stiffness)
                                 : stiffness;
    transmission.damping += context.parameters[kDamping];
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::JointCompliance>("joint_compliance"))
