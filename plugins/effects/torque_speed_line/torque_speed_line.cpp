#include "torque_speed_line.h"

#include <lacuna/element_checks.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kStall, kNoLoad };

}  // namespace

EffectDescription TorqueSpeedLine::describe() const {
  return {.summary = "A motor whose largest force falls with its speed, as its voltage is limited",
          .equation = "-stall*(1 + v/no_load) <= tau <= stall*(1 - v/no_load)",
          .literature = "A. Hughes, B. Drury, Electric Motors and Drives, Newnes 2013, chapter 3",
          .regime = "large commands at high speed",
          .look_alikes = {"torque_saturation", "viscous_friction"},
          .placements = {ElementKind::actuator},
          .parameters = {
              {"stall", "{force}", 10000.0, 1e-6, 1e6, Scale::logarithmic, "Largest force at rest, at the joint"},
              {"no_load", "{position}/s", 1000.0, 0.001, 1e6, Scale::logarithmic,
               "Velocity of the joint at which no force is left"}}};
}

void TorqueSpeedLine::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements) actuator_of_force(robot, actuator);
}

double TorqueSpeedLine::command(double value, int which, const StepView& view, const EffectContext& context,
                                std::span<double>) const {
  const auto actuator = static_cast<std::size_t>(context.elements[static_cast<std::size_t>(which)]);
  const double v = view.velocities[static_cast<std::size_t>(view.actuator_coordinate[actuator])];
  const double stall = context.parameters[kStall], speed = v / context.parameters[kNoLoad];
  return std::clamp(value, -stall * (1.0 + speed), stall * (1.0 - speed));
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::TorqueSpeedLine>("torque_speed_line"))
