#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

/// A drive whose force is not proportional to its command: it grows with the square, or saturates.
class CommandBend : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  EffectStages stages() const override { return {.command = CommandStage::saturation}; }
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

EffectDescription CommandBend::describe() const {
  return {.summary = "A drive whose force is not proportional to its command",
          .equation = "u_out = u + bend*|u|*u; for bend < 0 it is constant beyond |u| = -1/(2*bend)",
          .literature = "T. I. Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control, Wiley 2011",
          .regime = "large commands compared with small ones",
          .look_alikes = {"torque_gain", "torque_saturation", "supply_sag"},
          .placements = {ElementKind::actuator},
          .parameters = {{"bend", "1/{command}", 0.0, -10000.0, 10000.0, Scale::linear,
                          "Relative change of the command, per unit of command"}}};
}

void CommandBend::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements) actuator_of_force(robot, actuator);
}

double CommandBend::command(double value, int, const StepView&, const EffectContext& context, std::span<double>) const {
  const double bend = context.parameters[0];
  double size = std::abs(value);
  if (bend < 0.0) size = std::min(size, -0.5 / bend);
  return std::copysign(size + bend * size * size, value);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::CommandBend>("command_bend"))
