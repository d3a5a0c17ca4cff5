#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A pure delay of an actuator's command.
class CommandDelay : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription CommandDelay::describe() const {
  return {.summary = "A pure delay of an actuator's command",
          .equation = "u_out(t) = u(t - delay)",
          .literature = "K. J. Astrom, B. Wittenmark, Computer-Controlled Systems, Prentice Hall 1997, section 2.7",
          .regime = "quick changes of the command",
          .look_alikes = {"actuator_lag", "sensor_delay", "clock_skew"},
          .placements = {ElementKind::actuator},
          .parameters = {{"delay", "s", 0.0, 0.0, 1.0, Scale::linear, "Delay"}}};
}

void CommandDelay::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements)
    robot.actuators[static_cast<std::size_t>(actuator)].delay += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::CommandDelay>("command_delay"))
