#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A pure delay of a sensor's readings.
class SensorDelay : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription SensorDelay::describe() const {
  return {.summary = "A pure delay of a sensor's readings",
          .equation = "y(t) = x(t - delay)",
          .literature = "K. J. Astrom, B. Wittenmark, Computer-Controlled Systems, Prentice Hall 1997, section 2.7",
          .regime = "fast motion",
          .look_alikes = {"sensor_lag", "command_delay", "clock_skew"},
          .placements = {ElementKind::sensor},
          .parameters = {
              {"delay", "s", 0.0, 0.0, 1.0, Scale::linear, "Delay; before the start the first reading is repeated"}}};
}

void SensorDelay::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int sensor : context.elements)
    robot.sensors[static_cast<std::size_t>(sensor)].delay += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SensorDelay>("sensor_delay"))
