#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Contacts that creep in proportion to the tangential force, like tyres.
class WheelSlip : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription WheelSlip::describe() const {
  return {.summary = "Contacts that creep in proportion to the tangential force, like tyres",
          .equation = "v_slip = creep*F_t",
          .literature = "H. B. Pacejka, Tyre and Vehicle Dynamics, Butterworth-Heinemann 2012, chapter 1",
          .regime = "driving and braking: the robot travels less than its wheels roll",
          .look_alikes = {"contact_friction", "sensor_scale", "torque_gain"},
          .placements = {ElementKind::world},
          .parameters = {{"creep", "m/(N*s)", 0.0, 0.0, 10.0, Scale::linear,
                          "Sliding velocity per tangential force, of each contact point"}}};
}

void WheelSlip::amend(RobotSpec& robot, const EffectContext& context) const {
  contact_with_ground(robot).creep += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::WheelSlip>("wheel_slip"))
