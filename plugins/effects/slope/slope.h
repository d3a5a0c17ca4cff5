#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A ground that is not level.
class Slope : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
