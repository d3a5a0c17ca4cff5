#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// A torque against a joint's motion, proportional to the square of its speed.
class QuadraticDamping : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

EffectDescription QuadraticDamping::describe() const {
  return {.summary = "Torque against a joint's motion, proportional to the square of its speed",
          .equation = "tau = -damping*|v|*v",
          .literature = "Lord Rayleigh, Philosophical Magazine 2 (1876) 430-441",
          .regime = "fast rotation of a wheel, fan or propeller; run-down that is fast at first and slow at the end",
          .look_alikes = {"quadratic_drag", "viscous_friction", "linear_drag"},
          .placements = {ElementKind::joint},
          .parameters = {{"damping", "{force}*s^2/{position}^2", 0.0, 0.0, 1e4, Scale::linear,
                          "Torque per square of angular velocity, on a slider force per square of velocity"}},
          .dissipative = true};
}

void QuadraticDamping::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void QuadraticDamping::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                                 StepLoads& loads) const {
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    const double v = view.velocities[coordinate];
    loads.joints[coordinate].force -= context.parameters[0] * std::abs(v) * v;
    loads.joints[coordinate].damping += 2.0 * context.parameters[0] * std::abs(v);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::QuadraticDamping>("quadratic_damping"))
