#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// An actuator whose supply has an internal resistance.
class SupplySag : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
