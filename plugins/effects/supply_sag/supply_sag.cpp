#include <lacuna/error.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// An actuator whose supply has an internal resistance.
class SupplySag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription SupplySag::describe() const {
  return {
      .summary = "An actuator whose supply voltage falls with the load",
      .equation =
          "F = (P - D*v)/(1 + sag*|P|); P: force at rest without sag; D*v: back-EMF part, for motors with a voltage",
      .literature =
          "P. Horowitz, W. Hill, The Art of Electronics, Cambridge University Press 2015, chapter 1; A. Hughes, B. "
          "Drury, Electric Motors and Drives, Newnes 2013, chapter 3",
      .regime = "large forces: they are smaller than small forces suggest",
      .look_alikes = {"torque_gain", "torque_saturation", "thermal_fade", "torque_speed_line"},
      .placements = {ElementKind::actuator},
      .parameters = {{"sag", "1/{force}", 0.0, 0.0, 10000.0, Scale::linear,
                      "Share of the supply voltage that is lost per actuator force"}}};
}

void SupplySag::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int element : context.elements) {
    ActuatorSpec& actuator = robot.actuators[static_cast<std::size_t>(element)];
    if (actuator.kind == ActuatorKind::motion)
      throw Error("actuator." + actuator.name +
                  " imposes a motion with any force that it needs; place the effect on actuators of another kind");
    actuator.supply_sag += context.parameters[0];
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::SupplySag>("supply_sag"))
