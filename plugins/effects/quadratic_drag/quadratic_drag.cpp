#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Drag of a turbulent medium on a body's centre of mass.
class QuadraticDrag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kArea, kDensity };

}  // namespace

EffectDescription QuadraticDrag::describe() const {
  return {.summary = "Drag on a body, proportional to the square of the velocity of its centre of mass",
          .equation = "F = -1/2*density*area*|v|*v",
          .literature = "Lord Rayleigh, Philosophical Magazine 2 (1876) 430-441",
          .regime = "fast motion; large swings decay faster than small ones",
          .look_alikes = {"linear_drag", "viscous_friction"},
          .placements = {ElementKind::body},
          .parameters = {{"area", "m^2", 0.0, 0.0, 1000.0, Scale::linear, "Drag coefficient times frontal area"},
                         {"density", "kg/m^3", 1.2, 0.001, 10000.0, Scale::logarithmic,
                          "Density of the medium: 1.2 for air, 1000 for water"}},
          .dissipative = true};
}

void QuadraticDrag::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                              StepLoads& loads) const {
  const double drag = 0.5 * context.parameters[kDensity] * context.parameters[kArea];
  for (const int element : context.elements) {
    const auto body = static_cast<std::size_t>(element);
    const Eigen::Vector3d& v = view.body_velocities[body];
    loads.bodies[body].force -= drag * v.norm() * v;
    loads.bodies[body].damping += 2.0 * drag * v.norm();  // along the motion; half as much across
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::QuadraticDrag>("quadratic_drag"))
