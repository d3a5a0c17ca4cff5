#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// First-order lag of an actuator's command, such as of a current loop or a valve.
class ActuatorLag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::lag}; }
  int state_size(const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

EffectDescription ActuatorLag::describe() const {
  return {.summary = "First-order lag of an actuator's command",
          .equation = "time*du_out/dt = u - u_out",
          .literature = "K. J. Astrom, R. M. Murray, Feedback Systems, Princeton University Press 2008, section 5.3",
          .regime = "quick changes of the command",
          .look_alikes = {"command_delay", "slew_rate_limit", "sensor_lag"},
          .placements = {ElementKind::actuator},
          .parameters = {{"time", "s", 0.0, 0.0, 10.0, Scale::linear, "Time constant"}}};
}

/// State of each actuator: u_out, and 1 once it has begun.
int ActuatorLag::state_size(const EffectContext& context) const {
  return 2 * static_cast<int>(context.elements.size());
}

double ActuatorLag::command(double value, int which, const StepView&, const EffectContext& context,
                            std::span<double> state) const {
  double& out = state[2 * static_cast<std::size_t>(which)];
  double& begun = state[2 * static_cast<std::size_t>(which) + 1];
  const double time = context.parameters[0];
  const double before = begun == 0.0 ? value : out;
  begun = 1.0;
  if (time <= 0.0) return out = value;
  const double left = before - value, steps = context.step / time;
  out = value + left * std::exp(-steps);
  return value - left * std::expm1(-steps) / steps;  // the mean over the step
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::ActuatorLag>("actuator_lag"))
