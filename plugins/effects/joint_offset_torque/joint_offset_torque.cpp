#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A constant torque on a joint: tau = tau0, such as from a cable, a spring far from its rest, or an amplifier's
/// offset. Positive torque turns the joint in its positive direction.
class JointOffsetTorque : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription JointOffsetTorque::describe() const {
  return {.summary = "A constant torque in a joint, in its positive direction",
          .equation = "tau = torque",
          .literature =
              "A. Janot, P.-O. Vandanjon, M. Gautier, IEEE Trans. Control Systems Technology 22 (2014) "
              "132-145 (the offset term of the joint dynamics)",
          .regime = "drift to one side; a rest position that is shifted in both directions of motion",
          .look_alikes = {"command_offset", "directional_friction", "cable_pull", "mount_tilt"},
          .placements = {ElementKind::joint},
          .parameters = {{"torque", "{force}", 0.0, -1e4, 1e4, Scale::linear,
                          "Torque in the joint's positive direction, on a slider force"}}};
}

void JointOffsetTorque::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_laws(robot, joint).force += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::JointOffsetTorque>("joint_offset_torque"))
