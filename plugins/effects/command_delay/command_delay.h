#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A pure delay of an actuator's command.
class CommandDelay : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
