#include "lugre_friction.h"

#include <lacuna/joint_laws.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kCoulomb, kExcess, kVelocity, kBristleStiffness, kBristleDamping, kViscous };

}  // namespace

EffectDescription LugreFriction::describe() const {
  return {
      .summary = "Dry friction with elastic bristles: it gives way before it slides",
      .equation =
          "dz/dt = v - bristle_stiffness*|v|/g(v)*z, tau = -(bristle_stiffness*z + bristle_damping*dz/dt + viscous*v), "
          "g = coulomb + excess*exp(-(v/velocity)^2)",
      .literature =
          "C. Canudas de Wit, H. Olsson, K. J. Astrom, P. Lischinsky, IEEE Trans. Automatic Control 40 (1995) 419-425",
      .regime = "reversals and slow motion; small motion that springs back before it slides",
      .look_alikes = {"coulomb_friction", "stribeck_friction", "hysteresis", "viscous_friction"},
      .placements = {ElementKind::joint},
      .parameters = {{"coulomb", "{force}", 0.0, 0.0, 10000.0, Scale::linear, "Friction when sliding fast"},
                     {"excess", "{force}", 0.0, 0.0, 10000.0, Scale::linear, "Break-away friction beyond that"},
                     {"velocity", "{position}/s", 0.05, 1e-6, 1000.0, Scale::logarithmic,
                      "Velocity over which the excess falls"},
                     {"bristle_stiffness", "{force}/{position}", 100.0, 0.001, 1e9, Scale::logarithmic,
                      "Stiffness of the bristles, before sliding begins"},
                     {"bristle_damping", "{force}*s/{position}", 0.0, 0.0, 100000.0, Scale::linear,
                      "Damping of the bristles"},
                     {"viscous", "{force}*s/{position}", 0.0, 0.0, 10000.0, Scale::linear,
                      "Friction per velocity of the sliding film"}},
      .dissipative = true};
}

int LugreFriction::state_size(const EffectContext& context) const {
  return 2 * static_cast<int>(context.elements.size());
}

void LugreFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

/// Implicit Euler in z and v: z' = (z + h·v')/d with d = 1 + h·σ0·|v|/g, so that the torque is linear in v'.
void LugreFriction::before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                                StepLoads& loads) const {
  const auto p = context.parameters;
  const double h = context.step;
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const std::size_t coordinate = coordinate_of(view, context.elements[i]);
    const double v = view.velocities[coordinate], ratio = v / p[kVelocity];
    const double g = p[kCoulomb] + p[kExcess] * std::exp(-ratio * ratio);
    double& z = state[2 * i];
    double& d = state[2 * i + 1];
    JointLoad& load = loads.joints[coordinate];
    load.damping += p[kViscous];
    if (g <= 0.0) {
      z = d = 0.0;
      continue;
    }
    d = 1.0 + h * p[kBristleStiffness] * std::abs(v) / g;
    load.damping += (p[kBristleStiffness] * h + p[kBristleDamping]) / d;
    load.force -= (p[kBristleStiffness] / d + p[kBristleDamping] * (1.0 / d - 1.0) / h) * z;
  }
}

void LugreFriction::after_step(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    if (state[2 * i + 1] == 0.0) continue;
    const double v = view.velocities[coordinate_of(view, context.elements[i])];
    state[2 * i] = (state[2 * i] + context.step * v) / state[2 * i + 1];
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::LugreFriction>("lugre_friction"))
