#include "diagnosis/unexplained_motion.h"

#include "diagnosis/channel_scatter.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMissed = 0.2;    // of the motion, RMS
constexpr double kScatters = 3.0;  // times the scatter, RMS

/// RMS of a channel around each trial's mean, and the scatter that it holds.
struct ChannelMotion {
  double size = 0.0, scatter = 0.0;
};

ChannelMotion motion_of(const std::vector<Trial>& trials, const std::string& channel) {
  double squares = 0.0, count = 0.0;
  ChannelMotion motion;
  for (const Trial& trial : trials)
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c) {
      if (trial.measured.channels[c].name != channel) continue;
      const auto column = static_cast<Eigen::Index>(c);
      const auto values = trial.measured.samples.col(column).array();
      const auto known = values.isFinite();
      const auto samples = static_cast<double>(known.count());
      if (samples == 0.0) continue;
      const double mean = known.select(values, 0.0).sum() / samples;
      squares += known.select(values - mean, 0.0).square().sum();
      count += samples;
      motion.scatter = std::max(motion.scatter, scatter_of(trial.measured, column));
    }
  motion.size = count > 0.0 ? std::sqrt(squares / count) : 0.0;
  return motion;
}

}  // namespace

std::vector<std::string> unexplained_motion(const BaseSolution& base, const std::vector<ChannelError>& errors) {
  std::vector<std::string> sentences;
  for (const ChannelError& error : errors) {
    const ChannelMotion motion = motion_of(base.trials, error.channel);
    const double missed = std::max(error.fit, error.floor);
    if (missed <= std::max(kMissed * motion.size, kScatters * motion.scatter)) continue;
    sentences.push_back(fmt::format(
        "{}: the model misses {} of a motion of {} (RMS), and no effect explains it: check units, columns and the "
        "robot; a command column that holds no command looks like this",
        error.channel, format_quantity(missed, error.unit), format_quantity(motion.size, error.unit)));
  }
  return sentences;
}

}  // namespace lacuna
