#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// First-order lag of a sensor's readings, such as of a filter.
class SensorLag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::lag}; }
  int state_size(const EffectContext& context) const override;
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
  double lateness(double time, const EffectContext& context) const override;
};

namespace {

constexpr std::size_t kChannels = 4;               // at most, of any sensor
constexpr std::size_t kBlock = 2 + 2 * kChannels;  // begun, time of the last reading, then x and y of each channel

}  // namespace

EffectDescription SensorLag::describe() const {
  return {
      .summary = "First-order lag of a sensor's readings, such as a filter",
      .equation = "time*dy/dt = x - y",
      .literature = "K. J. Astrom, R. M. Murray, Feedback Systems, Princeton University Press 2008, section 5.3",
      .regime = "fast motion",
      .look_alikes = {"sensor_delay", "actuator_lag"},
      .placements = {ElementKind::sensor},
      .parameters = {{"time", "s", 0.0, 0.0, 10.0, Scale::linear, "Time constant; it starts at the first reading"}}};
}

int SensorLag::state_size(const EffectContext& context) const {
  return static_cast<int>(kBlock * context.elements.size());
}

void SensorLag::sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
                      std::span<double> state) const {
  const std::span<double> own = state.subspan(kBlock * static_cast<std::size_t>(which), kBlock);
  const double time = context.parameters[0];
  if (time <= 0.0) return;
  const bool begins = own[0] == 0.0;
  const double steps = begins ? 0.0 : (view.time - own[1]) / time;
  const double decay = std::exp(-steps);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    double& x = own[2 + 2 * c];
    double& y = own[3 + 2 * c];
    if (begins) x = y = channels[c];
    // The response to a ramp from x to the new reading.
    const double slope = steps > 0.0 ? (channels[c] - x) / steps : 0.0;
    y = channels[c] - slope + (y - x + slope) * decay;
    x = channels[c];
    channels[c] = y;
  }
  own[0] = 1.0;
  own[1] = view.time;
}

double SensorLag::lateness(double /*time*/, const EffectContext& context) const { return context.parameters[0]; }

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SensorLag>("sensor_lag"))
