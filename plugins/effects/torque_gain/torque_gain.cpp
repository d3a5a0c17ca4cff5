#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// An actuator whose force is too large or too small by a factor.
class TorqueGain : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription TorqueGain::describe() const {
  return {.summary = "Actuator force that is too large or too small by a constant factor",
          .equation = "tau_out = gain*tau",
          .literature = "M. Gautier, S. Briot, J. Dynamic Systems, Measurement, and Control 136 (2014) 051025",
          .regime = "all motion that the motor drives",
          .look_alikes = {"payload", "armature", "load_friction"},
          .placements = {ElementKind::actuator},
          .parameters = {{"gain", "1", 1.0, 0.01, 100.0, Scale::logarithmic, "Actual force over nominal force"}}};
}

void TorqueGain::amend(RobotSpec& robot, const EffectContext& context) const {
  const double gain = context.parameters[0];
  for (const int element : context.elements) {
    ActuatorSpec& actuator = robot.actuators[static_cast<std::size_t>(element)];
    if (actuator.kind == ActuatorKind::force) {
      actuator.gain *= gain;
    } else if (actuator.kind == ActuatorKind::voltage || actuator.kind == ActuatorKind::voltage_servo) {
      actuator.motor.resistance /= gain;
    } else {
      actuator.kp *= gain;
      actuator.ki *= gain;
      actuator.kd *= gain;
    }
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::TorqueGain>("torque_gain"))
