#pragma once

#include <span>

/// Commands that several benches are driven with.
namespace bench {

struct Tone {
  double amplitude, frequency, phase;  ///< N·m, Hz, rad
};

/// The sum of the tones at `time` s, N·m.
double multitone(std::span<const Tone> tones, double time);

/// `levels`, each held for `held` s and reached within 50 ms; the last one lasts.
double held_levels(std::span<const double> levels, double held, double time);

}  // namespace bench
