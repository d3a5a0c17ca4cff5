#include <lacuna/element_checks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A ground that is not level.
class Slope : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

EffectDescription Slope::describe() const {
  return {.summary = "A ground that is not level",
          .equation = "the ground is turned about the y axis by angle",
          .literature = "T. McGeer, Int. J. Robotics Research 9 (1990) 62-82",
          .regime = "motion over the ground: faster in one direction than in the other",
          .look_alikes = {"mount_tilt", "joint_offset_torque"},
          .placements = {ElementKind::world},
          .parameters = {{"angle", "rad", 0.0, -1.2, 1.2, Scale::linear,
                          "Rotation of the ground about the y axis; positive descends along +x"}}};
}

void Slope::amend(RobotSpec& robot, const EffectContext& context) const {
  contact_with_ground(robot).slope += context.parameters[0];
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Slope>("slope"))
