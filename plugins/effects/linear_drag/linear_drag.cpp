#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Drag of a viscous medium on a body's centre of mass.
class LinearDrag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

EffectDescription LinearDrag::describe() const {
  return {.summary = "Drag on a body, proportional to the velocity of its centre of mass",
          .equation = "F = -drag*v",
          .literature = "G. G. Stokes, Trans. Cambridge Philosophical Society 9 (1851) 8",
          .regime = "motion through a viscous medium; a free swing that decays by the same share in each period",
          .look_alikes = {"viscous_friction", "quadratic_drag"},
          .placements = {ElementKind::body},
          .parameters = {{"drag", "N*s/m", 0.0, 0.0, 100000.0, Scale::linear, "Force per velocity"}},
          .dissipative = true};
}

void LinearDrag::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                           StepLoads& loads) const {
  for (const int element : context.elements) {
    const auto body = static_cast<std::size_t>(element);
    loads.bodies[body].force -= context.parameters[0] * view.body_velocities[body];
    loads.bodies[body].damping += context.parameters[0];
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::LinearDrag>("linear_drag"))
