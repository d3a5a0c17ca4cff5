#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// A limit on the force of an actuator.
class TorqueSaturation : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription TorqueSaturation::describe() const {
  return {.summary = "A limit on the force of an actuator",
          .equation = "tau_out = min(limit, max(-limit, tau))",
          .literature = "K. J. Astrom, R. M. Murray, Feedback Systems, Princeton University Press 2008, section 10.4",
          .regime = "large commands",
          .look_alikes = {"torque_speed_line", "slew_rate_limit", "torque_gain"},
          .placements = {ElementKind::actuator},
          .parameters = {{"limit", "{force}", 10000.0, 1e-6, 1e6, Scale::logarithmic, "Largest force, at the joint"}}};
}

void TorqueSaturation::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int element : context.elements) {
    double& limit = robot.actuators[static_cast<std::size_t>(element)].force_limit;
    limit = std::min(limit, context.parameters[0]);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::TorqueSaturation>("torque_saturation"))
