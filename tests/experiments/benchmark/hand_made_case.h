#pragma once

#include "cases/make_case.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// A law and its parameters.
struct SizedPlacedLaw {
  std::string law;
  int element = 0;
  std::vector<double> parameters;
};

/// Three fit trials of the servo pendulum that begin at rest, `samples` long, their readings without noise.
MadeCase pendulum_case(const std::vector<SizedPlacedLaw>& hidden, const CaseNoise& noise, std::size_t samples);

/// 0.5 mrad of white noise on the angle.
CaseNoise white_noise();

/// Slow noise, a coarse encoder, a random torque and noise on the recorded command.
CaseNoise disturbed_noise();

/// Carries the fit trials out again, with random forces and noise that follow from `seed`.
void make_noisy(MadeCase& made, std::uint64_t seed);

}  // namespace hidden_effects
