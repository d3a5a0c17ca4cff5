#pragma once

#include "cases/make_case.h"

namespace hidden_effects {

/// What a law's size is searched with: a case whose noise is chosen, and the excitations of its fit trials, without and
/// with random forces.
struct SizedLaw {
  const MadeCase& made;
  PlacedLaw law;
  Scales scales;
  Shape shape;
  std::vector<Excitation> excitations, disturbed;
};

/// The law's parameters at the size at which what the refitted base leaves of it, without noise, is `wanted` times what
/// noise and random forces leave of a right model: RMS over trials and sensors, each sensor in units of its own noise.
/// A size that is out of reach is the largest that was tried.
std::vector<double> parameters_of_strength(const SizedLaw& task, double wanted);

/// Refits base and truth to the recorded fit trials and fills `strength`, `absorbed`, `base_rms` and `truth_rms`.
void measure_strength(MadeCase& made);

}  // namespace hidden_effects
