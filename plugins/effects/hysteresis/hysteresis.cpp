#include "hysteresis.h"

#include <lacuna/joint_laws.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kTorque, kDistance, kSharpness };

}  // namespace

EffectDescription Hysteresis::describe() const {
  return {.summary = "An elastic torque in a joint that remembers where motion came from",
          .equation = "tau = -torque*z, dz/dt = (v - sharpness*|v|*z + (sharpness - 1)*v*|z|)/distance",
          .literature =
              "Y.-K. Wen, J. Engineering Mechanics Division ASCE 102 (1976) 249-263; F. Ikhouane, J. Rodellar, "
              "Nonlinear Dynamics 42 (2005) 63-78",
          .regime = "reversals; loops in torque against position that do not depend on speed",
          .look_alikes = {"coulomb_friction", "lugre_friction", "joint_spring"},
          .placements = {ElementKind::joint},
          .parameters = {{"torque", "{force}", 0.0, 0.0, 10000.0, Scale::linear,
                          "Size of the torque once the motion goes on in one direction"},
                         {"distance", "{position}", 0.05, 1e-6, 1000.0, Scale::logarithmic,
                          "Way over which it turns round after a reversal"},
                         {"sharpness", "1", 0.5, 0.5, 10.0, Scale::linear,
                          "How much softer it loads than it unloads; 0.5: alike"}},
          .dissipative = true};
}

int Hysteresis::state_size(const EffectContext& context) const { return 3 * static_cast<int>(context.elements.size()); }

void Hysteresis::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

/// Implicit Euler in z and v: z' = (z + a·v')/d, so that the torque is linear in v'. State: z, a, d of each joint.
void Hysteresis::before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                             StepLoads& loads) const {
  const auto p = context.parameters;
  const double rate = context.step / p[kDistance];
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const std::size_t coordinate = coordinate_of(view, context.elements[i]);
    const double z = state[3 * i];
    const double a = rate * (1.0 + (p[kSharpness] - 1.0) * std::abs(z));
    const double d = 1.0 + rate * p[kSharpness] * std::abs(view.velocities[coordinate]);
    state[3 * i + 1] = a;
    state[3 * i + 2] = d;
    loads.joints[coordinate].damping += p[kTorque] * a / d;
    loads.joints[coordinate].force -= p[kTorque] * z / d;
  }
}

void Hysteresis::after_step(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const double v = view.velocities[coordinate_of(view, context.elements[i])];
    state[3 * i] = (state[3 * i] + state[3 * i + 1] * v) / state[3 * i + 2];
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Hysteresis>("hysteresis"))
