#include "bad_effect.h"

namespace rig {
double gear_ratio(int gear);  // nobody defines it
}

namespace {

/// As sound as an effect can be without one of its functions.
class Geared : public bad::Effect {
 public:
  void amend(lacuna::RobotSpec& robot, const lacuna::EffectContext&) const override {
    robot.joints.at(0).damping *= rig::gear_ratio(2);
  }
};

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, Geared>("geared"))
