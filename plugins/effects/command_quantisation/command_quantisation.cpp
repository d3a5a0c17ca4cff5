#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// A drive that rounds its command to whole steps.
class CommandQuantisation : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::quantisation}; }
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

EffectDescription CommandQuantisation::describe() const {
  return {.summary = "An actuator that rounds its command to whole steps",
          .equation = "u_out = step*round(u/step)",
          .literature = "B. Widrow, I. Kollar, Quantization Noise, Cambridge University Press 2008",
          .regime = "small commands, and commands that change slowly",
          .look_alikes = {"dead_zone", "command_offset"},
          .placements = {ElementKind::actuator},
          .parameters = {{"step", "{command}", 0.0, 0.0, 10000.0, Scale::linear, "Distance of neighbouring commands"}}};
}

double CommandQuantisation::command(double value, int, const StepView&, const EffectContext& context,
                                    std::span<double>) const {
  const double step = context.parameters[0], rounded = step * std::round(value / step);
  return step > 0.0 && std::isfinite(rounded) ? rounded : value;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::CommandQuantisation>("command_quantisation"))
