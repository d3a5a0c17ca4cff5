#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// An actuator that ignores small commands.
class DeadZone : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::dead_zone}; }
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

EffectDescription DeadZone::describe() const {
  return {
      .summary = "An actuator that ignores small commands",
      .equation = "u_out = 0 for |u| <= width, else u - width*sgn(u)",
      .literature =
          "G. Tao, P. V. Kokotovic, Adaptive Control of Systems with Actuator and Sensor Nonlinearities, Wiley 1996",
      .regime = "small commands",
      .look_alikes = {"coulomb_friction", "backlash"},
      .placements = {ElementKind::actuator},
      .parameters = {{"width", "{command}", 0.0, 0.0, 10000.0, Scale::linear,
                      "Half the width: the largest command without effect"}}};
}

double DeadZone::command(double value, int, const StepView&, const EffectContext& context, std::span<double>) const {
  const double width = context.parameters[0];
  return value - std::clamp(value, -width, width);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::DeadZone>("dead_zone"))
