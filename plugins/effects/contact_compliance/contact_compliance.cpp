#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Elastic ground contact whose damping grows with the penetration (Hunt and Crossley).
class ContactCompliance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

namespace {

enum Parameter : std::size_t { kStiffness, kDamping };

}  // namespace

EffectDescription ContactCompliance::describe() const {
  return {.summary = "Elastic contact of bodies and ground, damped in proportion to its penetration",
          .equation = "F_n = stiffness*x*(1 + damping*dx/dt)",
          .literature = "K. H. Hunt, F. R. E. Crossley, J. Applied Mechanics 42 (1975) 440-445",
          .regime = "touch-down: duration and depth of contacts",
          .look_alikes = {"restitution", "base_compliance"},
          .placements = {ElementKind::world},
          .parameters = {{"stiffness", "N/m", 1e6, 1.0, 1e9, Scale::logarithmic,
                          "Normal force per penetration, of each contact point"},
                         {"damping", "s/m", 0.0, 0.0, 1000.0, Scale::linear,
                          "Share of the elastic force per velocity of penetration"}},
          .neutral = {1e9, 0.0}};
}

void ContactCompliance::amend(RobotSpec& robot, const EffectContext& context) const {
  ContactSpec& contact = contact_with_ground(robot);
  contact.stiffness = 1.0 / (1.0 / context.parameters[kStiffness] + 1.0 / contact.stiffness);
  contact.impact_damping += context.parameters[kDamping];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::ContactCompliance>("contact_compliance"))
