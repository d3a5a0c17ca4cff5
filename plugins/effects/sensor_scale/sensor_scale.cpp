#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A sensor whose readings are too large or too small by a factor.
class SensorScale : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::scale}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

EffectDescription SensorScale::describe() const {
  return {.summary = "Sensor readings that are too large or too small by a constant factor",
          .equation = "y = scale*x",
          .literature = "JCGM 200:2012, International Vocabulary of Metrology, 4.12",
          .regime = "large excursions",
          .look_alikes = {"torque_gain", "encoder_eccentricity"},
          .placements = {ElementKind::sensor},
          .parameters = {{"scale", "1", 1.0, 0.01, 100.0, Scale::logarithmic, "Reading over true value"}}};
}

void SensorScale::sense(std::span<double> channels, int, const StepView&, const EffectContext& context,
                        std::span<double>) const {
  for (double& value : channels) value *= context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SensorScale>("sensor_scale"))
