#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// An eccentric encoder disc: an error that repeats with the reading.
class EncoderEccentricity : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::geometry}; }
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kSine, kCosine, kPeriods };

}  // namespace

EffectDescription EncoderEccentricity::describe() const {
  return {.summary = "A sensor error that repeats with the reading, such as from an eccentric encoder disc",
          .equation = "y = x + sine*sin(periods*x) + cosine*cos(periods*x)",
          .literature = "J. R. R. Mayer, IEEE Trans. Instrumentation and Measurement 43 (1994) 494-498",
          .regime = "motion over a wide range: an error that repeats with the position",
          .look_alikes = {"sensor_scale", "cogging", "sensor_offset"},
          .placements = {ElementKind::sensor},
          .parameters = {{"sine", "{channel}", 0.0, -10.0, 10.0, Scale::linear, "Amplitude of the sine"},
                         {"cosine", "{channel}", 0.0, -10.0, 10.0, Scale::linear, "Amplitude of the cosine"},
                         {"periods", "1/{channel}", 1.0, 0.5, 100000.0, Scale::logarithmic,
                          "Periods per 2 pi of the reading: 1 is once per turn"}}};
}

void EncoderEccentricity::sense(std::span<double> channels, int, const StepView&, const EffectContext& context,
                                std::span<double>) const {
  const auto p = context.parameters;
  for (double& value : channels) {
    const double phase = p[kPeriods] * value;
    value += p[kSine] * std::sin(phase) + p[kCosine] * std::cos(phase);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::EncoderEccentricity>("encoder_eccentricity"))
