#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Dry friction with different sizes in the two directions of motion.
class DirectionalFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kPositive, kNegative };

}  // namespace

EffectDescription DirectionalFriction::describe() const {
  return {
      .summary = "Dry friction in a joint that differs between the two directions of motion",
      .equation = "tau = -positive for v > 0, +negative for v < 0; at rest between the two",
      .literature = "A. Janot, P.-O. Vandanjon, M. Gautier, IEEE Trans. Control Systems Technology 22 (2014) 132-145",
      .regime = "slow motion in both directions; oscillation that drifts to one side",
      .look_alikes = {"coulomb_friction", "joint_offset_torque", "command_offset"},
      .placements = {ElementKind::joint},
      .parameters = {{"positive", "{force}", 0.0, 0.0, 10000.0, Scale::linear,
                      "Friction against motion in the positive direction"},
                     {"negative", "{force}", 0.0, 0.0, 10000.0, Scale::linear,
                      "Friction against motion in the negative direction"}},
      .dissipative = true};
}

void DirectionalFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void DirectionalFriction::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                                    StepLoads& loads) const {
  for (const int joint : context.elements) {
    JointLoad& load = loads.joints[coordinate_of(view, joint)];
    load.friction_lower -= context.parameters[kPositive];
    load.friction_upper += context.parameters[kNegative];
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::DirectionalFriction>("directional_friction"))
