#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A constant that is added to an actuator's command.
class CommandOffset : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
