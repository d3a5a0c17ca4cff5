#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Dry friction of constant size in a joint: tau = −Fc·sgn v, and at rest any force up to Fc that holds the joint (C.
/// A. Coulomb, Théorie des machines simples, 1785).
class CoulombFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription CoulombFriction::describe() const {
  return {.summary = "Dry friction of constant size in a joint, with stiction",
          .equation = "tau = -torque*sgn(v); at rest, any torque up to `torque` that holds the joint",
          .literature =
              "C. A. Coulomb, Théorie des machines simples, 1785; B. Armstrong-Hélouvry, P. Dupont, "
              "C. Canudas de Wit, Automatica 30 (1994) 1083-1138",
          .regime = "slow motion and reversals",
          .look_alikes = {"stribeck_friction", "lugre_friction", "hysteresis"},
          .placements = {ElementKind::joint},
          .parameters = {{"torque", "{force}", 0.0, 0.0, 1e4, Scale::linear,
                          "Friction torque, on a slider friction force"}},
          .dissipative = true};
}

void CoulombFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_laws(robot, joint).dry_friction += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::CoulombFriction>("coulomb_friction"))
