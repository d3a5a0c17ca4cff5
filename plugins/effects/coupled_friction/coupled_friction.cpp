#include <lacuna/error.h>
#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// Friction of the velocity at which two joints move a common gear or belt.
class CoupledFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kViscous, kDry, kVelocity, kRatio };

/// Friction over coupled velocity, finite where that is 0.
double friction_per_velocity(std::span<const double> p, double r) {
  const double x = r / p[kVelocity];
  return p[kViscous] + p[kDry] / p[kVelocity] * (std::abs(x) < 1e-4 ? 1.0 : std::tanh(x) / x);
}

}  // namespace

EffectDescription CoupledFriction::describe() const {
  return {
      .summary = "Friction of the common motion of two joints in a differential or a belt drive",
      .equation =
          "r = v1 + ratio*v2, f = viscous*r + dry*tanh(r/velocity), tau1 = -f, tau2 = -ratio*f; 1 and 2 in the "
          "order of the robot's joints",
      .literature = "A. Janot, P.-O. Vandanjon, M. Gautier, IEEE Trans. Control Systems Technology 22 (2014) 132-145",
      .regime = "motion of both joints at once",
      .look_alikes = {"viscous_friction", "coulomb_friction"},
      .placements = {ElementKind::joint},
      .parameters = {{"viscous", "{force}*s/{position}", 0.0, 0.0, 10000.0, Scale::linear,
                      "Friction over the coupled velocity"},
                     {"dry", "{force}", 0.0, 0.0, 10000.0, Scale::linear, "Dry friction of the coupled motion"},
                     {"velocity", "{position}/s", 0.01, 1e-6, 1000.0, Scale::logarithmic,
                      "Coupled velocity at which three quarters of the dry friction act"},
                     {"ratio", "1", 1.0, -100.0, 100.0, Scale::linear,
                      "Weight of the second joint's velocity in the coupled velocity"}},
      .dissipative = true};
}

void CoupledFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
  if (context.elements.size() != 2)
    throw Error("it acts between two joints; name two, as in where = [\"joint.pitch\", \"joint.roll\"]");
}

/// A joint's slope cannot express the decrease of its force with the other joint's velocity. The slope used instead is
/// so large that no common motion makes the friction decrease faster: then the engine's velocities converge from one
/// side.
void CoupledFriction::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                                StepLoads& loads) const {
  const auto p = context.parameters;
  const std::size_t first = coordinate_of(view, context.elements[0]), second = coordinate_of(view, context.elements[1]);
  const double ratio = p[kRatio], size = std::abs(ratio);
  const double r = view.velocities[first] + ratio * view.velocities[second];
  const double c = friction_per_velocity(p, r);
  loads.joints[first].force -= c * r;
  loads.joints[first].damping += c * (1.0 + size);
  loads.joints[second].force -= ratio * c * r;
  loads.joints[second].damping += c * (size * size + size);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::CoupledFriction>("coupled_friction"))
