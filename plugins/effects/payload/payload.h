#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A point mass carried by a body.
class Payload : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
