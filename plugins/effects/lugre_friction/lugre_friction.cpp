#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>
#include <lacuna/relaxation.h>

#include <cmath>

namespace lacuna {

/// Dry friction with elastic bristles (LuGre): presliding, break-away, Stribeck curve and rate dependence in one
/// law.
class LugreFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  int state_size(const EffectContext& context) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
  void advance(const StepView& view, const EffectContext& context, std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kCoulomb, kExcess, kVelocity, kBristleStiffness, kBristleDamping, kViscous };

/// The force of steady sliding at a velocity.
double break_away(std::span<const double> p, double v) {
  const double ratio = v / p[kVelocity];
  return p[kCoulomb] + p[kExcess] * std::exp(-ratio * ratio);
}

}  // namespace

EffectDescription LugreFriction::describe() const {
  return {
      .summary = "Dry friction with elastic bristles: an elastic displacement precedes sliding",
      .equation =
          "dz/dt = v - bristle_stiffness*|v|/g(v)*z, tau = -(bristle_stiffness*z + bristle_damping*dz/dt + viscous*v), "
          "g = coulomb + excess*exp(-(v/velocity)^2)",
      .literature =
          "C. Canudas de Wit, H. Olsson, K. J. Astrom, P. Lischinsky, IEEE Trans. Automatic Control 40 (1995) 419-425",
      .regime = "reversals and slow motion; small displacements that spring back",
      .look_alikes = {"coulomb_friction", "stribeck_friction", "hysteresis", "viscous_friction"},
      .placements = {ElementKind::joint},
      .parameters =
          {{"coulomb", "{force}", 0.0, 0.0, 10000.0, Scale::linear, "Coulomb friction, at high sliding speed"},
           {"excess", "{force}", 0.0, 0.0, 10000.0, Scale::linear, "Break-away friction minus Coulomb friction"},
           {"velocity", "{position}/s", 0.05, 1e-6, 1000.0, Scale::logarithmic,
            "Velocity at which the excess has decayed"},
           {"bristle_stiffness", "{force}/{position}", 100.0, 0.001, 1e9, Scale::logarithmic,
            "Stiffness of the bristles, before sliding begins"},
           {"bristle_damping", "{force}*s/{position}", 0.0, 0.0, 100000.0, Scale::linear, "Damping of the bristles"},
           {"viscous", "{force}*s/{position}", 0.0, 0.0, 10000.0, Scale::linear, "Viscous friction per velocity"}},
      .dissipative = true};
}

int LugreFriction::state_size(const EffectContext& context) const { return static_cast<int>(context.elements.size()); }

void LugreFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void LugreFriction::add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                              StepLoads& loads) const {
  const auto p = context.parameters;
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const std::size_t coordinate = coordinate_of(view, context.elements[i]);
    const double v = view.velocities[coordinate], z = state[i];
    JointLoad& load = loads.joints[coordinate];
    load.add_damping(p[kViscous], v);
    if (break_away(p, v) <= 0.0) continue;
    const Relaxation bend(p[kBristleStiffness] * std::abs(v) / break_away(p, v), context.step);
    const double mean = bend.mean_carried * z + bend.mean_gained * v;
    const double change = (bend.carried - 1.0) * z + bend.gained * v;
    load.force -= p[kBristleStiffness] * mean + p[kBristleDamping] * change / context.step;
    load.damping += p[kBristleStiffness] * bend.mean_gained + p[kBristleDamping] * bend.mean_carried;
  }
}

void LugreFriction::advance(const StepView& view, const EffectContext& context, std::span<double> state) const {
  const auto p = context.parameters;
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const double v = view.velocities[coordinate_of(view, context.elements[i])], g = break_away(p, v);
    if (g <= 0.0) {
      state[i] = 0.0;
      continue;
    }
    const Relaxation bend(p[kBristleStiffness] * std::abs(v) / g, context.step);
    state[i] = bend.carried * state[i] + bend.gained * v;
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::LugreFriction>("lugre_friction"))
