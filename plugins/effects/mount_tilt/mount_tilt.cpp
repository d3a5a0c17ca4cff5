#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A rig that is not level: gravity is tilted in its frame.
class MountTilt : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

namespace {

enum Parameter : std::size_t { kRoll, kPitch };

}  // namespace

EffectDescription MountTilt::describe() const {
  return {.summary = "A rig that is not level: gravity is tilted in its frame",
          .equation = "g = Rx(roll)^-1*Ry(pitch)^-1*g0",
          .literature =
              "B. Siciliano, L. Sciavicco, L. Villani, G. Oriolo, Robotics, Springer 2009, section 7.1 (gravity in the "
              "base "
              "frame)",
          .regime = "rest and slow motion: the rest position is shifted",
          .look_alikes = {"joint_offset_torque", "sensor_offset", "cable_pull"},
          .placements = {ElementKind::world},
          .parameters = {
              {"roll", "rad", 0.0, -1.6, 1.6, Scale::linear, "Rotation of the rig about its x axis"},
              {"pitch", "rad", 0.0, -1.6, 1.6, Scale::linear, "Rotation of the rig about the y axis, applied first"}}};
}

void MountTilt::amend(RobotSpec& robot, const EffectContext& context) const {
  if (context.parameters[kRoll] == 0.0 && context.parameters[kPitch] == 0.0) return;
  const Eigen::Quaterniond turn = Eigen::AngleAxisd(context.parameters[kPitch], Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(context.parameters[kRoll], Eigen::Vector3d::UnitX());
  robot.gravity = turn.conjugate() * robot.gravity;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::MountTilt>("mount_tilt"))
