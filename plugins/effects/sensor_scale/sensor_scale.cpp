#include "sensor_scale.h"

#include <lacuna/plugin.h>

namespace lacuna {

EffectDescription SensorScale::describe() const {
  return {.summary = "A sensor's readings are too large or too small, by a constant factor",
          .equation = "y = scale*x",
          .literature = "JCGM 200:2012, International Vocabulary of Metrology, 4.12",
          .regime = "large excursions",
          .look_alikes = {"torque_gain", "encoder_eccentricity"},
          .placements = {ElementKind::sensor},
          .parameters = {{"scale", "1", 1.0, 0.01, 100.0, Scale::logarithmic, "Reading over what is true"}}};
}

void SensorScale::sense(std::span<double> channels, int, const StepView&, const EffectContext& context,
                        std::span<double>) const {
  for (double& value : channels) value *= context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SensorScale>("sensor_scale"))
