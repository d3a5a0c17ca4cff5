#include "diagnosis/verdict/unexplained_motion.h"

#include "diagnosis/data_checks/channel_scatter.h"
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

/// The error of a channel, and how large one still allows a verdict.
struct MissedMotion {
  double size = 0.0, missed = 0.0, allowed = 0.0;
};

MissedMotion missed_motion_of(const BaseSolution& base, const ChannelError& error) {
  const ChannelMotion motion = motion_of(base.trials, error.channel);
  return {motion.size, std::max(error.fit, error.floor), std::max(kMissed * motion.size, kScatters * motion.scatter)};
}

}  // namespace

double missed_motion(const BaseSolution& base, const std::vector<ChannelError>& errors) {
  double most = 0.0;
  for (const ChannelError& error : errors)
    if (const MissedMotion one = missed_motion_of(base, error); one.missed > 0.0)
      most = std::max(most, one.missed / one.allowed);
  return most;
}

std::vector<std::string> unexplained_motion(const BaseSolution& base, const std::vector<ChannelError>& errors) {
  std::vector<std::string> sentences;
  for (const ChannelError& error : errors) {
    const MissedMotion one = missed_motion_of(base, error);
    if (one.missed <= one.allowed) continue;
    sentences.push_back(fmt::format(
        "{}: the model misses {} of a motion of {} (RMS), and no effect explains it: check units, columns and the "
        "robot; a command column that holds no command looks like this",
        error.channel, format_quantity(one.missed, error.unit), format_quantity(one.size, error.unit)));
  }
  return sentences;
}

}  // namespace lacuna
