#include "effects/lugre.h"

#include <cmath>

namespace lacuna {

EffectDescription LuGre::describe() const {
  return {.summary = "Dry friction with elastic bristles",
          .equation = "dz/dt = v - sigma0*|v|/g(v)*z, tau = -(sigma0*z + sigma1*dz/dt + sigma2*v)",
          .literature = "C. Canudas de Wit et al., IEEE Trans. Automatic Control 40 (1995) 419",
          .regime = "reversals and slow motion",
          .look_alikes = {"coulomb_friction", "stribeck_friction"},
          .placements = {ElementKind::joint},
          .parameters = {{"sigma0", "N*m/rad", 1e3, 0.0, 1e8, Scale::logarithmic, "Stiffness of the bristles"},
                         {"sigma1", "N*m*s/rad", 1.0, 0.0, 1e5, Scale::linear, "Damping of the bristles"},
                         {"sigma2", "N*m*s/rad", 0.0, 0.0, 1e5, Scale::linear, "Viscous friction"},
                         {"coulomb", "N*m", 1.0, 1e-9, 1e5, Scale::linear, "Friction when sliding fast"},
                         {"stiction", "N*m", 1.0, 1e-9, 1e5, Scale::linear, "Friction at break-away"},
                         {"stribeck_velocity", "rad/s", 0.01, 1e-6, 1e2, Scale::linear, "Velocity of the transition"}}};
}

void LuGre::before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                        StepLoads& loads) const {
  const auto p = context.parameters;
  const double h = context.step;
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const auto coordinate =
        static_cast<std::size_t>(view.first_coordinate[static_cast<std::size_t>(context.elements[i])]);
    const double v = view.velocities[coordinate];
    const double ratio = v / p[stribeck_velocity];
    const double g = p[coulomb] + (p[stiction] - p[coulomb]) * std::exp(-ratio * ratio);
    double& z = state[2 * i];
    double& d = state[2 * i + 1];
    d = 1.0 + h * p[sigma0] * std::abs(v) / g;
    JointLoad& load = loads.joints[coordinate];
    load.damping += (p[sigma0] * h + p[sigma1]) / d + p[sigma2];
    load.force -= (p[sigma0] / d + p[sigma1] * (1.0 / d - 1.0) / h) * z;
  }
}

void LuGre::after_step(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const auto coordinate =
        static_cast<std::size_t>(view.first_coordinate[static_cast<std::size_t>(context.elements[i])]);
    state[2 * i] = (state[2 * i] + context.step * view.velocities[coordinate]) / state[2 * i + 1];
  }
}

}  // namespace lacuna
