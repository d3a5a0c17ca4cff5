#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Inertia in a joint's own coordinate, as of a rotor behind a gear.
class Armature : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
