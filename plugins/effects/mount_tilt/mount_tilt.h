#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A rig that does not stand level: gravity is tilted in its frame.
class MountTilt : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
