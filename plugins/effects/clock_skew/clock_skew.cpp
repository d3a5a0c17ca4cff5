#include <lacuna/error.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// A sensor whose clock runs faster or slower than that of the commands (D. L. Mills, IEEE Trans. Communications 39
/// (1991) 1482). Readings at other times than the present are interpolated by a parabola through the last three
/// readings, for time shifts that are short compared with the motion.
class ClockSkew : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::delay}; }
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  int state_size(const EffectContext& context) const override;
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
  double lateness(double time, const EffectContext& context) const override;
};

namespace {

constexpr std::size_t kChannels = 4;  // at most, of any sensor

/// The memory of one sensor: its last two readings.
struct Memory {
  explicit Memory(std::span<double> state)
      : count(state[0]), time1(state[1]), time2(state[2]), x1(state.subspan(3)), x2(state.subspan(3 + kChannels)) {}
  static constexpr std::size_t kSize = 3 + 2 * kChannels;

  double& count;
  double &time1, &time2;
  std::span<double> x1, x2;
};

/// Newton's parabola through (now, x) and the stored readings, as many as there are, at now + shift.
double extrapolated(double x, std::size_t channel, double now, double shift, const Memory& memory) {
  if (memory.count < 1.0) return x;
  const double first = (x - memory.x1[channel]) / (now - memory.time1);
  if (memory.count < 2.0) return x + shift * first;
  const double before = (memory.x1[channel] - memory.x2[channel]) / (memory.time1 - memory.time2);
  const double second = (first - before) / (now - memory.time2);
  return x + shift * (first + (shift + now - memory.time1) * second);
}

}  // namespace

EffectDescription ClockSkew::describe() const {
  return {.summary = "A sensor's clock runs faster or slower than that of the commands",
          .equation = "y(t) = x(t/(1 + skew)), along a parabola through the last readings",
          .literature = "D. L. Mills, IEEE Trans. Communications 39 (1991) 1482-1493",
          .regime = "long trials: readings agree with commands at the beginning but not at the end",
          .look_alikes = {"sensor_delay", "command_delay", "sensor_drift"},
          .placements = {ElementKind::sensor},
          .parameters = {
              {"skew", "1", 0.0, -0.02, 0.02, Scale::linear, "Rate error of the clock: 1e-3 is 1 ms per second"}}};
}

int ClockSkew::state_size(const EffectContext& context) const {
  return static_cast<int>(Memory::kSize * context.elements.size());
}

void ClockSkew::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int element : context.elements) {
    const SensorSpec& sensor = robot.sensors[static_cast<std::size_t>(element)];
    if (sensor.kind == SensorKind::touch || sensor.kind == SensorKind::contact_force)
      throw Error("sensor." + sensor.name +
                  " reads contacts, whose values jump and have no slope; place the effect on sensors of motion");
  }
}

void ClockSkew::sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
                      std::span<double> state) const {
  Memory memory(state.subspan(Memory::kSize * static_cast<std::size_t>(which), Memory::kSize));
  const double skew = context.parameters[0], now = view.time;
  const double shift = -now * skew / (1.0 + skew);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const double x = channels[c];
    channels[c] = extrapolated(x, c, now, shift, memory);
    memory.x2[c] = memory.x1[c];
    memory.x1[c] = x;
  }
  memory.time2 = memory.time1;
  memory.time1 = now;
  memory.count = std::min(2.0, memory.count + 1.0);
}

double ClockSkew::lateness(double time, const EffectContext& context) const {
  return time * context.parameters[0] / (1.0 + context.parameters[0]);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::ClockSkew>("clock_skew"))
