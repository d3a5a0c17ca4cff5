#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Coulomb friction between bodies and ground.
class ContactFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription ContactFriction::describe() const {
  return {.summary = "Coulomb friction with a given coefficient between bodies and ground",
          .equation = "|F_t| <= coefficient*F_n",
          .literature = "C. A. Coulomb, Theorie des machines simples, 1785",
          .regime = "sliding feet and wheels",
          .look_alikes = {"wheel_slip", "rolling_resistance"},
          .placements = {ElementKind::world},
          .parameters = {{"coefficient", "1", 1.0, 0.0, 10.0, Scale::linear,
                          "Largest tangential force over the normal force"}},
          .neutral = {10.0}};
}

void ContactFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  contact_with_ground(robot).friction = context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::ContactFriction>("contact_friction"))
