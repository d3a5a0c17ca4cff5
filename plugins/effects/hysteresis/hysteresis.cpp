#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>
#include <lacuna/relaxation.h>

#include <cmath>

namespace lacuna {

/// Elastic force with a memory of the direction of motion (Bouc–Wen with exponent 1).
class Hysteresis : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  int state_size(const EffectContext& context) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
  void advance(const StepView& view, const EffectContext& context, std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kTorque, kDistance, kSharpness };

/// Rate of z at constant v: its equation is then dz/dt = v/distance - decay*z.
double decay(std::span<const double> p, double v, double z) {
  const double along = z > 0.0 ? v : z < 0.0 ? -v : 0.0;
  return (p[kSharpness] * std::abs(v) - (p[kSharpness] - 1.0) * along) / p[kDistance];
}

}  // namespace

EffectDescription Hysteresis::describe() const {
  return {.summary = "An elastic torque in a joint that depends on the path of the motion",
          .equation = "tau = -torque*z, dz/dt = (v - sharpness*|v|*z + (sharpness - 1)*v*|z|)/distance",
          .literature =
              "Y.-K. Wen, J. Engineering Mechanics Division ASCE 102 (1976) 249-263; F. Ikhouane, J. Rodellar, "
              "Nonlinear Dynamics 42 (2005) 63-78",
          .regime = "reversals; loops in torque against position that do not depend on speed",
          .look_alikes = {"coulomb_friction", "lugre_friction", "joint_spring"},
          .placements = {ElementKind::joint},
          .parameters = {{"torque", "{force}", 0.0, 0.0, 10000.0, Scale::linear,
                          "Magnitude of the torque after a long motion in one direction"},
                         {"distance", "{position}", 0.05, 1e-6, 1000.0, Scale::logarithmic,
                          "Distance over which the torque changes sign after a reversal"},
                         {"sharpness", "1", 0.5, 0.5, 10.0, Scale::linear,
                          "How much softer it loads than it unloads; 0.5: equal"}},
          .dissipative = true};
}

int Hysteresis::state_size(const EffectContext& context) const { return static_cast<int>(context.elements.size()); }

void Hysteresis::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void Hysteresis::add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                           StepLoads& loads) const {
  const auto p = context.parameters;
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const std::size_t coordinate = coordinate_of(view, context.elements[i]);
    const double v = view.velocities[coordinate];
    const Relaxation bend(decay(p, v, state[i]), context.step);
    JointLoad& load = loads.joints[coordinate];
    load.force -= p[kTorque] * (bend.mean_carried * state[i] + bend.mean_gained * v / p[kDistance]);
    load.damping += p[kTorque] * bend.mean_gained / p[kDistance];
  }
}

void Hysteresis::advance(const StepView& view, const EffectContext& context, std::span<double> state) const {
  const auto p = context.parameters;
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const double v = view.velocities[coordinate_of(view, context.elements[i])];
    const Relaxation bend(decay(p, v, state[i]), context.step);
    state[i] = bend.carried * state[i] + bend.gained * v / p[kDistance];
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Hysteresis>("hysteresis"))
