#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// Dry friction that is larger at rest and falls to the Coulomb level when the joint begins to move.
class StribeckFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kCoulomb, kExcess, kVelocity };

}  // namespace

EffectDescription StribeckFriction::describe() const {
  return {.summary = "Dry friction that falls from break-away to Coulomb level when a joint begins to move",
          .equation = "tau = -(coulomb + excess*exp(-(v/velocity)^2))*sgn(v); at rest up to coulomb + excess",
          .literature =
              "R. Stribeck, VDI-Zeitschrift 46 (1902) 1341; B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, "
              "Automatica 30 (1994) 1083-1138",
          .regime = "very slow motion, stick-slip, the first moments after a reversal",
          .look_alikes = {"coulomb_friction", "lugre_friction", "hysteresis"},
          .placements = {ElementKind::joint},
          .parameters = {{"coulomb", "{force}", 0.0, 0.0, 10000.0, Scale::linear,
                          "Coulomb friction, at high sliding speed"},
                         {"excess", "{force}", 0.0, 0.0, 10000.0, Scale::linear,
                          "Break-away friction minus Coulomb friction"},
                         {"velocity", "{position}/s", 0.05, 1e-6, 1000.0, Scale::logarithmic,
                          "Velocity at which the excess has decayed"}},
          .dissipative = true};
}

void StribeckFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void StribeckFriction::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                                 StepLoads& loads) const {
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    const double ratio = view.velocities[coordinate] / context.parameters[kVelocity];
    loads.joints[coordinate].add_friction(context.parameters[kCoulomb] +
                                          context.parameters[kExcess] * std::exp(-ratio * ratio));
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::StribeckFriction>("stribeck_friction"))
