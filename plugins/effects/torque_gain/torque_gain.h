#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// An actuator whose force is larger or smaller than its command says.
class TorqueGain : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
