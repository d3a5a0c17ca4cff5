#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>
#include <lacuna/relaxation.h>

#include <cmath>

namespace lacuna {

/// An actuator that weakens as it warms up.
class ThermalFade : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::gain}; }
  void start(const StepView& view, const EffectContext& context, std::span<double> state) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  int state_size(const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kFade, kTime };
/// State of each actuator: its heat at a time, and the command since then.
enum Memory : std::size_t { kHeat, kSince, kCommand, kSize };

}  // namespace

EffectDescription ThermalFade::describe() const {
  return {
      .summary = "An actuator that weakens as it warms up",
      .equation = "u_out = u/(1 + heat), time*dheat/dt = fade*u^2 - heat",
      .literature =
          "J. R. Hendershot, T. J. E. Miller, Design of Brushless Permanent-Magnet Machines, Motor Design Books 2010, "
          "chapter 14",
      .regime = "long trials under load: the actuator is weaker at the end than at the beginning",
      .look_alikes = {"torque_gain", "viscous_friction"},
      .placements = {ElementKind::actuator},
      .parameters = {
          {"fade", "1/{command}^2", 0.0, 0.0, 1e6, Scale::linear, "Final loss of force, per squared command"},
          {"time", "s", 60.0, 0.1, 100000.0, Scale::logarithmic, "Time constant of warming and cooling"}}};
}

void ThermalFade::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements) actuator_of_force(robot, actuator);
}

int ThermalFade::state_size(const EffectContext& context) const {
  return static_cast<int>(kSize * context.elements.size());
}

void ThermalFade::start(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) state[kSize * i + kSince] = view.time;
}

double ThermalFade::command(double value, int which, const StepView& view, const EffectContext& context,
                            std::span<double> state) const {
  const std::span<double> own = state.subspan(kSize * static_cast<std::size_t>(which), kSize);
  const double fade = context.parameters[kFade], cooling = 1.0 / context.parameters[kTime];
  const double end_before = fade * own[kCommand] * own[kCommand], end = fade * value * value;
  const Relaxation passed(cooling, view.time - own[kSince]), coming(cooling, context.step);
  own[kHeat] = end_before + (own[kHeat] - end_before) * passed.carried;
  own[kSince] = view.time;
  own[kCommand] = value;
  return value / (1.0 + end + (own[kHeat] - end) * coming.mean_carried);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::ThermalFade>("thermal_fade"))
