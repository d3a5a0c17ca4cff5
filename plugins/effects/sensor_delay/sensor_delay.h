#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// A pure delay of a sensor's readings.
class SensorDelay : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

}  // namespace lacuna
