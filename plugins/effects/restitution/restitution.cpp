#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// Bodies that bounce off the ground.
class Restitution : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription Restitution::describe() const {
  return {.summary = "Bodies that bounce off the ground",
          .equation = "v_n' = -coefficient*v_n",
          .literature = "I. Newton, Philosophiae Naturalis Principia Mathematica, 1687, Scholium to the laws of motion",
          .regime = "impacts",
          .look_alikes = {"contact_compliance"},
          .placements = {ElementKind::world},
          .parameters = {{"coefficient", "1", 0.0, 0.0, 1.0, Scale::linear,
                          "Normal velocity after an impact over the velocity before"}}};
}

void Restitution::amend(RobotSpec& robot, const EffectContext& context) const {
  ContactSpec& contact = contact_with_ground(robot);
  contact.restitution = std::max(contact.restitution, context.parameters[0]);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Restitution>("restitution"))
