#pragma once

#include <lacuna/genome.h>

namespace lacuna {

/// The genome of `morphology` that says exactly what the robot `five_cylinders` is: rows of parent, end, length in m,
/// roll, turn, touch. The front part and both arms on the torso's head, the rear part on its tail.
inline Genome five_cylinders_genome() {
  constexpr double kMetre = 1.0, kArm = 0.8;
  constexpr double kHead = 1.0, kTail = 0.0, kTouch = 1.0, kNone = 0.0, kTorso = 0.0;
  return {
      kTorso, kTail, kMetre, 0.0, 0.0, kNone,   //
      kTorso, kHead, kMetre, 0.0, 0.0, kTouch,  // straight on
      kTorso, kTail, kMetre, 0.0, 1.0, kTouch,  // turned by π
      kTorso, kHead, kArm,   0.0, 0.5, kNone,   // turned by π/2 to the left
      kTorso, kHead, kArm,   1.0, 0.5, kNone,   // rolled over first: to the right
  };
}

}  // namespace lacuna
