#pragma once

#include <cstddef>
#include <vector>

namespace lacuna {

/// The settings of a waveform.
struct WaveformTask {
  double low = 0.0;       ///< Hz
  double high = 0.0;      ///< Hz, at least `low`
  double duration = 0.0;  ///< s
  double interval = 0.0;  ///< s, from sample to sample
  std::size_t samples = 0;
  unsigned seed = 0;  ///< of phases and levels
};

/// Samples within −1 ... 1 at 0, interval, 2 interval ... Each call starts anew; the same task gives the same samples.

/// Up to 32 sines of equal amplitude whose frequencies are multiples of 1/duration between `low` and `high`, evenly
/// spread on a logarithmic scale, with random phases, scaled such that the largest sample has magnitude 1. Without such
/// a multiple, one sine at the geometric mean of the band.
std::vector<double> multisine(const WaveformTask& task);
/// Random levels, each held for 1/low, scaled such that the largest has magnitude 1.
std::vector<double> steps(const WaveformTask& task);
/// A sine whose frequency grows exponentially from `low` to `high`.
std::vector<double> chirp(const WaveformTask& task);
/// Triangle wave of the frequency `low`, starting upwards from 0.
std::vector<double> triangle(const WaveformTask& task);

}  // namespace lacuna
