#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Friction proportional to a joint's velocity: tau = −b·v, such as from a lubricated bearing or a motor's back-EMF.
class ViscousFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription ViscousFriction::describe() const {
  return {.summary = "Friction in a joint, proportional to its velocity",
          .equation = "tau = -damping*v",
          .literature = "B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994) 1083-1138",
          .regime = "fast motion; a free swing that decays by the same share in each period",
          .look_alikes = {"linear_drag", "torque_speed_line", "quadratic_damping"},
          .placements = {ElementKind::joint},
          .parameters = {{"damping", "{force}*s/{position}", 0.0, 0.0, 1e4, Scale::linear,
                          "Friction torque per angular velocity, on a slider force per velocity"}},
          .dissipative = true};
}

void ViscousFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_laws(robot, joint).damping += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::ViscousFriction>("viscous_friction"))
