#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A constant that is added to a sensor's readings.
class SensorOffset : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::offset}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

EffectDescription SensorOffset::describe() const {
  return {.summary = "A constant added to a sensor's readings",
          .equation = "y = x + offset",
          .literature = "JCGM 200:2012, International Vocabulary of Metrology, 4.20",
          .regime = "rest: the reading has the same error at every position",
          .look_alikes = {"mount_tilt", "command_offset", "joint_offset_torque"},
          .placements = {ElementKind::sensor},
          .parameters = {{"offset", "{channel}", 0.0, -10000.0, 10000.0, Scale::linear,
                          "Added constant, for every channel of the sensor"}}};
}

void SensorOffset::sense(std::span<double> channels, int, const StepView&, const EffectContext& context,
                         std::span<double>) const {
  for (double& value : channels) value += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SensorOffset>("sensor_offset"))
