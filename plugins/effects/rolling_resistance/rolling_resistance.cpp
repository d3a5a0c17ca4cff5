#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Resistance of the ground to rolling and turning.
class RollingResistance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription RollingResistance::describe() const {
  return {.summary = "Resistance of the ground to rolling bodies",
          .equation = "|M| <= lever*F_n against rolling",
          .literature = "O. Reynolds, Philosophical Transactions 166 (1876) 155-174",
          .regime = "free rolling, which slows down at a constant rate",
          .look_alikes = {"coulomb_friction", "contact_friction", "slope"},
          .placements = {ElementKind::world},
          .parameters = {{"lever", "m", 0.0, 0.0, 1.0, Scale::linear, "Moment against rolling over the normal force"}},
          .dissipative = true};
}

void RollingResistance::amend(RobotSpec& robot, const EffectContext& context) const {
  contact_with_ground(robot).rolling_lever += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::RollingResistance>("rolling_resistance"))
