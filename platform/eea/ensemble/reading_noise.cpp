#include "eea/ensemble/reading_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kLeastShare = 1e-3;  // of a channel's range or constant value

}  // namespace

void ReadingNoise::add(const Trial& trial, const std::vector<Eigen::Index>& map, const TimeSeries& predicted) {
  for (std::size_t c = 0; c < map.size(); ++c) {
    Tally& tally = channels_[static_cast<std::size_t>(map[c])];
    const auto column = static_cast<Eigen::Index>(c);
    if (c < trial.sensor_noise.size() && std::isfinite(trial.sensor_noise[c]))
      tally.declared = std::max(tally.declared, trial.sensor_noise[c]);
    for (Eigen::Index row = 0; row < trial.measured.samples.rows(); ++row) {
      const double measured = trial.measured.samples(row, column);
      if (!std::isfinite(measured)) continue;
      const double left = measured - predicted.samples(row, map[c]);
      tally.lowest = tally.samples > 0.0 ? std::min(tally.lowest, measured) : measured;
      tally.highest = tally.samples > 0.0 ? std::max(tally.highest, measured) : measured;
      tally.squares += left * left;
      tally.samples += 1.0;
    }
  }
}

std::vector<double> ReadingNoise::deviations() const {
  std::vector<double> deviations;
  for (const Tally& tally : channels_) {
    const double left = std::sqrt(tally.squares / std::max(1.0, tally.samples));
    const double moved = std::max({tally.highest - tally.lowest, std::abs(tally.lowest), std::abs(tally.highest)});
    const double seen = tally.declared > 0.0 ? tally.declared : std::max(left, kLeastShare * moved);
    deviations.push_back(tally.samples > 0.0 ? seen : std::numeric_limits<double>::infinity());
  }
  return deviations;
}

}  // namespace lacuna
