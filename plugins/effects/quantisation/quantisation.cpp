#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// A sensor that rounds its readings to whole steps.
class Quantisation : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription Quantisation::describe() const {
  return {.summary = "A sensor that rounds its readings to whole steps",
          .equation = "y = step*round(x/step)",
          .literature = "B. Widrow, I. Kollar, Quantization Noise, Cambridge University Press 2008",
          .regime = "slow motion and rest: the reading is constant between jumps",
          .look_alikes = {"sensor_saturation", "dead_zone"},
          .placements = {ElementKind::sensor},
          .parameters = {{"step", "{channel}", 0.0, 0.0, 10000.0, Scale::linear, "Distance of neighbouring readings"}}};
}

void Quantisation::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int sensor : context.elements) {
    double& quantum = robot.sensors[static_cast<std::size_t>(sensor)].quantum;
    quantum = std::max(quantum, context.parameters[0]);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Quantisation>("quantisation"))
