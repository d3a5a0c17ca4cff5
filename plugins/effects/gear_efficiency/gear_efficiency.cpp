#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// Dry friction of a gear proportional to the actuators' force, with different ratios where that force drives and where
/// it brakes.
class GearEfficiency : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kDrive, kBackdrive };

}  // namespace

EffectDescription GearEfficiency::describe() const {
  return {
      .summary = "Dry friction of a gear proportional to its load, with different ratios for driving and back-driving",
      .equation =
          "tau = -ratio*|tau_actuator|*sgn(v); ratio = drive_ratio for tau_actuator*v > 0, backdrive_ratio for "
          "tau_actuator*v < 0",
      .literature =
          "P. Hamon, M. Gautier, P. Garrec, IROS 2010, 6187-6193; M. Duclusaud, G. Passault, V. Padois, O. Ly, "
          "arXiv:2410.08650, 2024",
      .regime = "raising and lowering a load: lifting needs more force than holding, lowering less",
      .look_alikes = {"load_friction", "coulomb_friction", "torque_gain"},
      .placements = {ElementKind::joint},
      .parameters = {{"drive_ratio", "1", 0.0, 0.0, 0.95, Scale::linear,
                      "Friction over the magnitude of the actuator force, where this force drives the motion"},
                     {"backdrive_ratio", "1", 0.0, 0.0, 10.0, Scale::linear,
                      "Friction over the magnitude of the actuator force, where this force brakes the motion"}},
      .dissipative = true};
}

void GearEfficiency::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

/// A force > 0 drives motion in the positive direction, which the lower limit of friction brakes.
void GearEfficiency::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                               StepLoads& loads) const {
  const double drive = context.parameters[kDrive], backdrive = context.parameters[kBackdrive];
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    JointLoad& load = loads.joints[coordinate];
    for (std::size_t a = 0; a < view.actuator_forces.size(); ++a) {
      if (view.actuator_coordinate[a] != static_cast<int>(coordinate)) continue;
      const double force = view.actuator_forces[a], size = std::abs(force);
      load.friction_lower -= (force > 0.0 ? drive : backdrive) * size;
      load.friction_upper += (force < 0.0 ? drive : backdrive) * size;
    }
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::GearEfficiency>("gear_efficiency"))
