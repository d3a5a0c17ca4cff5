#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// Play between an actuator's rotor and its joint.
class Backlash : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

namespace {

enum Parameter : std::size_t { kGap, kStiffness, kDamping };

}  // namespace

EffectDescription Backlash::describe() const {
  return {
      .summary = "Play between an actuator's rotor and its joint",
      .equation =
          "tau = stiffness*dz(rotor - q) + damping*(d rotor/dt - v) in contact, 0 in the gap; dz is 0 within +-gap/2",
      .literature = "M. Nordin, P.-O. Gutman, Automatica 38 (2002) 1633-1649",
      .regime = "reversals of the load: a short free motion, then an impact",
      .look_alikes = {"joint_compliance", "hysteresis", "dead_zone"},
      .placements = {ElementKind::actuator},
      .parameters =
          {{"gap", "{position}", 0.0, 0.0, 10.0, Scale::linear, "Whole width of the play, at the joint"},
           {"stiffness", "{force}/{position}", 10000.0, 0.001, 1e9, Scale::logarithmic,
            "Stiffness of the flanks; in an elastic transmission, the transmission's stiffness is used instead"},
           {"damping", "{force}*s/{position}", 0.0, 0.0, 1e6, Scale::linear, "Damping of the flanks"}},
      .neutral = {0.0, 1e9, 0.0}};
}

void Backlash::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements) {
    TransmissionSpec& transmission = robot.actuators[static_cast<std::size_t>(actuator)].transmission;
    transmission.gap += context.parameters[kGap];
    transmission.stiffness = std::min(transmission.stiffness, context.parameters[kStiffness]);
    transmission.damping += context.parameters[kDamping];
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Backlash>("backlash"))
