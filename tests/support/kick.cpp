#include "support/kick.h"

#include <string>

namespace lacuna {

EffectDescription Kick::describe() const {
  EffectDescription description{.summary = "A push in the first step",
                                .equation = "force = impulse/h, torque = angular_impulse/h for 0 <= t < h",
                                .literature = "test only",
                                .regime = "the first step",
                                .look_alikes = {},
                                .placements = {ElementKind::body},
                                .parameters = {}};
  for (const char* name : {"impulse_x", "impulse_y", "impulse_z"})
    description.parameters.push_back({name, "N*s", 0.0, -1e3, 1e3, Scale::linear, "Impulse"});
  for (const char* name : {"angular_impulse_x", "angular_impulse_y", "angular_impulse_z"})
    description.parameters.push_back({name, "N*m*s", 0.0, -1e3, 1e3, Scale::linear, "Angular impulse"});
  return description;
}

void Kick::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                     StepLoads& loads) const {
  if (view.time > 0.75 * context.step) return;
  const auto p = context.parameters;
  for (const int element : context.elements) {
    BodyLoad& load = loads.bodies[static_cast<std::size_t>(element)];
    load.force += Eigen::Vector3d(p[0], p[1], p[2]) / context.step;
    load.torque += Eigen::Vector3d(p[3], p[4], p[5]) / context.step;
  }
}

}  // namespace lacuna
