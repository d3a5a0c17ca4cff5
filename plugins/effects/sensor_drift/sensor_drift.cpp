#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A sensor reading that drifts at a constant rate.
class SensorDrift : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::drift}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

EffectDescription SensorDrift::describe() const {
  return {.summary = "A sensor reading that drifts at a constant rate",
          .equation = "y = x + rate*t",
          .literature = "JCGM 200:2012, International Vocabulary of Metrology, 4.21",
          .regime = "long trials: the reading drifts, whatever the robot does",
          .look_alikes = {"clock_skew", "sensor_offset", "thermal_fade"},
          .placements = {ElementKind::sensor},
          .parameters = {{"rate", "{channel}/s", 0.0, -1000.0, 1000.0, Scale::linear,
                          "Change per second, from the start of the trial"}}};
}

void SensorDrift::sense(std::span<double> channels, int, const StepView& view, const EffectContext& context,
                        std::span<double>) const {
  for (double& value : channels) value += context.parameters[0] * view.time;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SensorDrift>("sensor_drift"))
