#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// Dry friction proportional to the force that the actuators transmit through the joint, as in a gear.
class LoadFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

EffectDescription LoadFriction::describe() const {
  return {.summary = "Dry friction in a joint proportional to its actuators' force",
          .equation = "tau = -ratio*|tau_actuator|*sgn(v)",
          .literature = "P. Hamon, M. Gautier, P. Garrec, IROS 2010, 6187-6193",
          .regime = "high load at any velocity; friction grows with the motor's effort",
          .look_alikes = {"coulomb_friction", "torque_gain"},
          .placements = {ElementKind::joint},
          .parameters = {
              {"ratio", "1", 0.0, 0.0, 0.95, Scale::linear, "Friction over the magnitude of the actuator force"}}};
}

void LoadFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void LoadFriction::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                             StepLoads& loads) const {
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    double load = 0.0;
    for (std::size_t a = 0; a < view.actuator_forces.size(); ++a)
      if (view.actuator_coordinate[a] == static_cast<int>(coordinate)) load += std::abs(view.actuator_forces[a]);
    loads.joints[coordinate].add_friction(context.parameters[0] * load);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::LoadFriction>("load_friction"))
