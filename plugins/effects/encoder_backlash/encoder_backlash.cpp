#include <lacuna/error.h>
#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>
#include <lacuna/relaxation.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

/// Play between a joint and an encoder on the motor side of its gear.
class EncoderBacklash : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  EffectStages stages() const override { return {.sensor = SensorStage::geometry}; }
  int state_size(const EffectContext& context) const override;
  void start(const StepView& view, const EffectContext& context, std::span<double> state) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
             std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kGap, kForce, kTime };
/// State of each sensor: position of the motor in the gap, -1 to 1, and its time.
enum Memory : std::size_t { kSide, kSince, kSize };

double actuator_force(const StepView& view, int coordinate) {
  double force = 0.0;
  for (std::size_t a = 0; a < view.actuator_forces.size(); ++a)
    if (view.actuator_coordinate[a] == coordinate) force += view.actuator_forces[a];
  return force;
}

}  // namespace

EffectDescription EncoderBacklash::describe() const {
  return {.summary = "Play between a joint and an encoder on the motor side of its gear",
          .equation = "y = x + gap/2*side, time*dside/dt = tanh(tau_actuator/force) - side",
          .literature = "M. Nordin, P.-O. Gutman, Automatica 38 (2002) 1633-1649",
          .regime = "reversals of the actuator's force: the reading jumps by the gap",
          .look_alikes = {"backlash", "joint_compliance", "hysteresis", "sensor_offset"},
          .placements = {ElementKind::sensor},
          .parameters = {{"gap", "{channel}", 0.0, 0.0, 10.0, Scale::linear, "Whole width of the play, at the joint"},
                         {"force", "{force}", 0.01, 1e-6, 10000.0, Scale::logarithmic,
                          "Actuator force that holds the motor at three quarters of the half gap"},
                         {"time", "s", 0.01, 1e-5, 100.0, Scale::logarithmic, "Time constant of crossing the gap"}}};
}

int EncoderBacklash::state_size(const EffectContext& context) const {
  return static_cast<int>(kSize * context.elements.size());
}

void EncoderBacklash::start(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) state[kSize * i + kSince] = view.time;
}

void EncoderBacklash::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int element : context.elements) {
    const SensorSpec& sensor = robot.sensors[static_cast<std::size_t>(element)];
    if (sensor.kind != SensorKind::joint_position)
      throw Error("sensor." + sensor.name + " reads no joint position; place the effect on encoders of joints");
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint)
      if (robot.joints[joint].name == sensor.element) joint_with_one_coordinate(robot, static_cast<int>(joint));
    if (std::none_of(robot.actuators.begin(), robot.actuators.end(),
                     [&](const ActuatorSpec& actuator) { return actuator.joint == sensor.element; }))
      throw Error("sensor." + sensor.name + " reads joint." + sensor.element +
                  ", which has no actuator; place the effect on encoders of driven joints");
  }
}

/// The forces in a view at the end of a step are the step's means.
void EncoderBacklash::sense(std::span<double> channels, int which, const StepView& view, const EffectContext& context,
                            std::span<double> state) const {
  const auto p = context.parameters;
  const std::span<double> own = state.subspan(kSize * static_cast<std::size_t>(which), kSize);
  const auto sensor = static_cast<std::size_t>(context.elements[static_cast<std::size_t>(which)]);
  const double pushed_to = std::tanh(actuator_force(view, view.sensor_coordinate[sensor]) / p[kForce]);
  own[kSide] = pushed_to + (own[kSide] - pushed_to) * Relaxation(1.0 / p[kTime], view.time - own[kSince]).carried;
  own[kSince] = view.time;
  channels[0] += 0.5 * p[kGap] * own[kSide];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::EncoderBacklash>("encoder_backlash"))
