#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// A sensor with a limited range.
class SensorSaturation : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::saturation}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kLower, kUpper };

}  // namespace

EffectDescription SensorSaturation::describe() const {
  return {.summary = "A sensor with a limited range",
          .equation = "y = min(upper, max(lower, x))",
          .literature = "JCGM 200:2012, International Vocabulary of Metrology, 4.7",
          .regime = "readings at the ends of the range",
          .look_alikes = {"hard_stop", "torque_saturation"},
          .placements = {ElementKind::sensor},
          .parameters = {{"lower", "{channel}", -10000.0, -1e6, 1e6, Scale::linear, "Smallest reading"},
                         {"upper", "{channel}", 10000.0, -1e6, 1e6, Scale::linear, "Largest reading"}}};
}

void SensorSaturation::sense(std::span<double> channels, int, const StepView&, const EffectContext& context,
                             std::span<double>) const {
  for (double& value : channels)
    value = std::max(context.parameters[kLower], std::min(context.parameters[kUpper], value));
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SensorSaturation>("sensor_saturation"))
