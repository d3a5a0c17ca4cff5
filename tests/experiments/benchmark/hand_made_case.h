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

/// The same of the arm with two links, its free values the nominal ones.
MadeCase two_link_case(const std::vector<SizedPlacedLaw>& hidden, const CaseNoise& noise, std::size_t samples);

/// 0.5 mrad of white noise on each angle of a rig with `sensors` of them.
CaseNoise white_noise(std::size_t sensors = 1);

/// Slow noise, a coarse encoder, a random torque and noise on the recorded command.
CaseNoise disturbed_noise();

/// Carries the fit trials out again, with random forces and noise that follow from `seed`.
void make_noisy(MadeCase& made, std::uint64_t seed);

}  // namespace hidden_effects
