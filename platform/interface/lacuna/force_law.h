#pragma once

#include <lacuna/dual.h>
#include <lacuna/physical_effect.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

/// Adds a force that is a smooth function law(q, v) of a joint's position and velocity, with its slopes where it
/// decreases. For a law as steep and short as tanh(v/0.001) the slope of the chord to v = 0 is used where it is
/// steeper, so that a step brings the joint at most to rest. `law` takes and returns `Dual`; for sgn(v) as a factor
/// there is `add_force_along_motion`.
template <class Law>
void add_force_law(JointLoad& load, double q, double v, const Law& law) {
  const Dual force = law(Dual::position(q), Dual::velocity(v));
  double damping = std::max(0.0, -force.by_velocity);
  if (v != 0.0) damping = std::max(damping, (law(Dual::position(q), Dual(0.0)).value - force.value) / v);
  load.force += force.value;
  load.damping += damping;
  load.stiffness += std::max(0.0, -force.by_position);
}

/// Adds the force `along`·sgn(v) to a joint's load: as dry friction, which sticks without chatter, where it opposes the
/// motion; as a force where it drives.
inline void add_force_along_motion(JointLoad& load, double v, double along) {
  if (along <= 0.0)
    load.add_friction(-along);
  else
    load.force += along * sgn(v).value;
}

}  // namespace lacuna
