#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Viscous friction with different sizes in the two directions of motion.
class DirectionalViscousFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kPositive, kNegative };

}  // namespace

EffectDescription DirectionalViscousFriction::describe() const {
  return {.summary = "Viscous friction in a joint that differs between the two directions of motion",
          .equation = "tau = -positive*v for v > 0, -negative*v for v < 0",
          .literature = "B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994) 1083-1138",
          .regime = "fast motion in both directions",
          .look_alikes = {"viscous_friction", "directional_friction", "quadratic_drag"},
          .placements = {ElementKind::joint},
          .parameters = {{"positive", "{force}*s/{position}", 0.0, 0.0, 10000.0, Scale::linear,
                          "Friction over velocity in motion in the positive direction"},
                         {"negative", "{force}*s/{position}", 0.0, 0.0, 10000.0, Scale::linear,
                          "Friction over velocity in motion in the negative direction"}},
          .dissipative = true};
}

void DirectionalViscousFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void DirectionalViscousFriction::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                                           StepLoads& loads) const {
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    const double v = view.velocities[coordinate];
    loads.joints[coordinate].add_damping(context.parameters[v < 0.0 ? kNegative : kPositive], v);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(
    lacuna::component<lacuna::PhysicalEffect, lacuna::DirectionalViscousFriction>("directional_viscous_friction"))
