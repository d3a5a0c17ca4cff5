#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Buoyancy of a body in a medium, at its centre of mass.
class Buoyancy : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

EffectDescription Buoyancy::describe() const {
  return {.summary = "Buoyancy of a body, which removes part of its weight but not of its inertia",
          .equation = "F = -displaced*g",
          .literature = "Archimedes, On Floating Bodies, about 250 BC",
          .regime = "rest and slow motion against gravity: less weight with the same inertia",
          .look_alikes = {"payload", "cable_pull"},
          .placements = {ElementKind::body},
          .parameters = {
              {"displaced", "kg", 0.0, 0.0, 10000.0, Scale::linear, "Mass of the medium that the body displaces"}}};
}

void Buoyancy::add_loads(const StepView&, const EffectContext& context, std::span<const double>,
                         StepLoads& loads) const {
  for (const int element : context.elements)
    loads.bodies[static_cast<std::size_t>(element)].force -= context.parameters[0] * loads.gravity;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Buoyancy>("buoyancy"))
