#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Inertia in the coordinate of a joint, such as of a rotor behind a gear.
class Armature : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription Armature::describe() const {
  return {.summary = "Inertia added to the coordinate of a joint, such as a rotor behind a gear",
          .equation = "tau = -inertia*d2q/dt2",
          .literature = "R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, section 9.6",
          .regime = "accelerations, especially at high frequency",
          .look_alikes = {"payload", "torque_gain"},
          .placements = {ElementKind::joint},
          .parameters = {{"inertia", "{inertia}", 0.0, 0.0, 10000.0, Scale::linear,
                          "Inertia at the joint; for a rotor: its inertia times the square of the gear ratio"}}};
}

void Armature::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_laws(robot, joint).armature += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Armature>("armature"))
