#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// A motor whose largest torque falls with its speed, because its voltage is limited.
class TorqueSpeedLine : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.command = CommandStage::saturation}; }
  int state_size(const EffectContext& context) const override;
  void start(const StepView& view, const EffectContext& context, std::span<double> state) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  double command(double value, int which, const StepView& view, const EffectContext& context,
                 std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kStall, kNoLoad };
/// State of each actuator: the last velocity of its joint, and its time.
enum Memory : std::size_t { kVelocity, kTime, kSize };

double velocity_of(const StepView& view, const EffectContext& context, std::size_t which) {
  const auto actuator = static_cast<std::size_t>(context.elements[which]);
  return view.velocities[static_cast<std::size_t>(view.actuator_coordinate[actuator])];
}

}  // namespace

EffectDescription TorqueSpeedLine::describe() const {
  return {.summary = "A motor whose largest force falls with its speed because its voltage is limited",
          .equation = "-stall*(1 + v/no_load) <= tau <= stall*(1 - v/no_load)",
          .literature = "A. Hughes, B. Drury, Electric Motors and Drives, Newnes 2013, chapter 3",
          .regime = "large commands at high speed",
          .look_alikes = {"torque_saturation", "viscous_friction"},
          .placements = {ElementKind::actuator},
          .parameters = {
              {"stall", "{force}", 10000.0, 1e-6, 1e6, Scale::logarithmic, "Largest force at rest, at the joint"},
              {"no_load", "{position}/s", 1000.0, 0.001, 1e6, Scale::logarithmic,
               "Velocity of the joint at which the largest force is zero"}}};
}

void TorqueSpeedLine::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int actuator : context.elements) actuator_of_force(robot, actuator);
}

int TorqueSpeedLine::state_size(const EffectContext& context) const {
  return static_cast<int>(kSize * context.elements.size());
}

void TorqueSpeedLine::start(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    state[kSize * i + kVelocity] = velocity_of(view, context, i);
    state[kSize * i + kTime] = view.time;
  }
}

/// For the velocity in the middle of the step, extrapolated from the last one.
double TorqueSpeedLine::command(double value, int which, const StepView& view, const EffectContext& context,
                                std::span<double> state) const {
  const std::span<double> own = state.subspan(kSize * static_cast<std::size_t>(which), kSize);
  const double now = velocity_of(view, context, static_cast<std::size_t>(which)), passed = view.time - own[kTime];
  const double rate = passed > 0.0 ? (now - own[kVelocity]) / passed : 0.0;
  own[kVelocity] = now;
  own[kTime] = view.time;
  const double v = now + 0.5 * context.step * rate;
  const double stall = context.parameters[kStall], speed = v / context.parameters[kNoLoad];
  return std::clamp(value, -stall * (1.0 + speed), stall * (1.0 - speed));
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::TorqueSpeedLine>("torque_speed_line"))
