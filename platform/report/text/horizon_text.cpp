#include "report/text/horizon_text.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

const ChannelScore* score_of(const TrialComparison& trial, const std::string& channel) {
  const auto found = std::find_if(trial.channels.begin(), trial.channels.end(),
                                  [&](const ChannelScore& score) { return score.channel == channel; });
  return found == trial.channels.end() ? nullptr : &*found;
}

std::vector<double> horizons_of(const Comparison& comparison, bool automatic) {
  std::vector<double> horizons;
  for (const TrialComparison& trial : comparison.trials)
    for (const HorizonScore& score : trial.horizons)
      if ((automatic || !score.automatic) &&
          std::find(horizons.begin(), horizons.end(), score.horizon) == horizons.end())
        horizons.push_back(score.horizon);
  return horizons;
}

double restarted_error(const Comparison& comparison, const std::string& channel, double horizon, bool held_out) {
  double squares = 0.0;
  int count = 0;
  for (const TrialComparison& trial : comparison.trials) {
    const ChannelScore* score = score_of(trial, channel);
    if (trial.held_out != held_out || !score) continue;
    for (const HorizonScore& restarted : trial.horizons) {
      const double error = restarted.rmse[static_cast<std::size_t>(score - trial.channels.data())];
      if (restarted.horizon != horizon || !std::isfinite(error)) continue;
      squares += error * error;
      ++count;
    }
  }
  return std::sqrt(squares / count);
}

}  // namespace lacuna
