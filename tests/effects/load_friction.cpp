#include "effects/load_friction.h"

#include <cmath>

namespace lacuna {

EffectDescription LoadFriction::describe() const {
  return {.summary = "Dry friction proportional to the actuator's force",
          .equation = "tau = -ratio*|tau_motor|*sgn(v)",
          .literature = "P. Hamon, M. Gautier, P. Garrec, IROS 2010",
          .regime = "high load at low velocity",
          .look_alikes = {"coulomb_friction"},
          .placements = {ElementKind::joint},
          .parameters = {{"ratio", "1", 0.0, 0.0, 1.0, Scale::linear, "Friction over the actuator's force"}}};
}

void LoadFriction::before_step(const StepView& view, const EffectContext& context, std::span<double>,
                               StepLoads& loads) const {
  for (const int joint : context.elements) {
    const int coordinate = view.first_coordinate[static_cast<std::size_t>(joint)];
    double load = 0.0;
    for (std::size_t a = 0; a < view.actuator_forces.size(); ++a)
      if (view.actuator_coordinate[a] == coordinate) load += std::abs(view.actuator_forces[a]);
    loads.joints[static_cast<std::size_t>(coordinate)].add_friction(context.parameters[0] * load);
  }
}

}  // namespace lacuna
