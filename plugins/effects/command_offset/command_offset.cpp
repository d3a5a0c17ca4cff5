#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A constant that is added to an actuator's command.
class CommandOffset : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription CommandOffset::describe() const {
  return {.summary = "A constant added to an actuator's command",
          .equation = "u_out = u + offset",
          .literature = "L. Ljung, System Identification, Prentice Hall 1999, section 14.1",
          .regime = "drift to one side with no command",
          .look_alikes = {"joint_offset_torque", "sensor_offset", "directional_friction"},
          .placements = {ElementKind::actuator},
          .parameters = {{"offset", "{command}", 0.0, -10000.0, 10000.0, Scale::linear, "Added constant"}}};
}

void CommandOffset::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements)
    robot.actuators[static_cast<std::size_t>(actuator)].offset += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::CommandOffset>("command_offset"))
