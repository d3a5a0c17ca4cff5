#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

/// A limit on how fast an actuator follows its command.
class SlewRateLimit : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::slew_rate}; }
  int state_size(const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

EffectDescription SlewRateLimit::describe() const {
  return {.summary = "A limit on how fast an actuator follows its command",
          .equation = "|du_out/dt| <= rate",
          .literature = "J.-J. E. Slotine, W. Li, Applied Nonlinear Control, Prentice Hall 1991, section 5.2",
          .regime = "large quick changes of the command",
          .look_alikes = {"actuator_lag", "command_delay", "torque_saturation"},
          .placements = {ElementKind::actuator},
          .parameters = {{"rate", "{command}/s", 1e6, 1e-6, 1e9, Scale::logarithmic, "Largest rate of change"}},
          .neutral = {1e9}};
}

/// State of each actuator: u_out, and 1 once it has begun.
int SlewRateLimit::state_size(const EffectContext& context) const {
  return 2 * static_cast<int>(context.elements.size());
}

double SlewRateLimit::command(double value, int which, const StepView&, const EffectContext& context,
                              std::span<double> state) const {
  double& out = state[2 * static_cast<std::size_t>(which)];
  double& begun = state[2 * static_cast<std::size_t>(which) + 1];
  const double before = begun == 0.0 ? value : out;
  begun = 1.0;
  const double way = value - before, reach = context.parameters[0] * context.step;
  out = before + std::clamp(way, -reach, reach);
  if (std::abs(way) >= reach) return 0.5 * (before + out);
  return value - 0.5 * way * std::abs(way) / reach;  // still approaching the command for a part of the step
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SlewRateLimit>("slew_rate_limit"))
