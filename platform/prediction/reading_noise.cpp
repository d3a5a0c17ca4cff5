#include "prediction/reading_noise.h"

#include "evaluation/prediction/trial_predictor.h"
#include "foundation/processes/stop.h"
#include "foundation/unit.h"
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

bool is_declared(const ChannelNoise& noise) { return noise.origin.starts_with("declared"); }

}  // namespace

std::vector<ChannelNoise> noise_of_readings(const SmoothedStarts& starts, const std::vector<Trial>& trials,
                                            std::vector<ChannelNoise> noise) {
  std::vector<double> squares(noise.size(), 0.0), counts(noise.size(), 0.0);
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t column = 0; column < trials[t].measured.channels.size(); ++column)
      for (std::size_t c = 0; c < noise.size(); ++c) {
        const double found = starts.reading_noise(t, static_cast<Eigen::Index>(column));
        if (noise[c].channel != trials[t].measured.channels[column].name || !(found > 0.0)) continue;
        squares[c] += found * found;
        counts[c] += 1.0;
      }
  for (std::size_t c = 0; c < noise.size(); ++c) {
    if (counts[c] == 0.0 || is_declared(noise[c])) continue;
    noise[c].deviation = std::sqrt(squares[c] / counts[c]);
    noise[c].origin = "estimated by smoothing the readings";
  }
  return noise;
}

ChannelNoise agreed(const ChannelNoise& other, const ChannelNoise& smoothed) {
  constexpr double kMotion = 2.0;
  if (smoothed.deviation <= kMotion * other.deviation) return smoothed;
  ChannelNoise kept = other;
  kept.origin += fmt::format("; lacuna diagnose takes {}, the scatter about the smoothed readings, which holds motion",
                             format_quantity(smoothed.deviation, smoothed.unit));
  return kept;
}

std::vector<ChannelNoise> noise_of_readings(const RobotSpec& robot, const TrialPredictor& predictor) {
  const std::vector<Trial>& trials = predictor.trials();
  std::vector<ChannelNoise> noise = sensor_noise(robot, trials);
  if (std::ranges::all_of(noise, is_declared)) return noise;
  try {
    const StartStates states(robot, predictor, noise);
    const std::vector<ChannelNoise> smoothed = noise_of_readings(SmoothedStarts(states, trials), trials, noise);
    for (std::size_t c = 0; c < noise.size(); ++c) noise[c] = agreed(noise[c], smoothed[c]);
    return noise;
  } catch (const Interrupted&) {
    throw;
  } catch (const Error&) {
    return noise;
  }
}

}  // namespace lacuna
