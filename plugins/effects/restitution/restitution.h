#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Bodies that bounce off the ground.
class Restitution : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
