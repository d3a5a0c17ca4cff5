#include "thermal_fade.h"

#include <lacuna/element_checks.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kFade, kTime };

}  // namespace

EffectDescription ThermalFade::describe() const {
  return {
      .summary = "An actuator that gets weaker as it gets warm",
      .equation = "u_out = u/(1 + heat), time*dheat/dt = fade*u^2 - heat",
      .literature =
          "J. R. Hendershot, T. J. E. Miller, Design of Brushless Permanent-Magnet Machines, Motor Design Books 2010, "
          "chapter 14",
      .regime = "long trials under load: the end is weaker than the beginning",
      .look_alikes = {"torque_gain", "viscous_friction"},
      .placements = {ElementKind::actuator},
      .parameters = {{"fade", "1/{command}^2", 0.0, 0.0, 1e6, Scale::linear,
                      "Loss that a command leads to in the end, per squared command"},
                     {"time", "s", 60.0, 0.1, 100000.0, Scale::logarithmic, "Time constant of warming and cooling"}}};
}

void ThermalFade::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements) actuator_of_force(robot, actuator);
}

int ThermalFade::state_size(const EffectContext& context) const { return static_cast<int>(context.elements.size()); }

double ThermalFade::command(double value, int which, const StepView&, const EffectContext& context,
                            std::span<double> state) const {
  double& heat = state[static_cast<std::size_t>(which)];
  const double faded = value / (1.0 + heat);
  const double end = context.parameters[kFade] * value * value;
  heat = end + (heat - end) * std::exp(-context.step / context.parameters[kTime]);
  return faded;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::ThermalFade>("thermal_fade"))
