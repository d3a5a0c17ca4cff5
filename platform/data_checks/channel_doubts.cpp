#include "data_checks/channel_doubts.h"

#include "data_checks/channel_scatter.h"
#include "foundation/address.h"
#include "foundation/unit.h"
#include "measurement/series/signal_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kStretch = 0.5;  // s, of which a diagnosis takes the prediction error as one
/// As many stretches that all favour a model by chance: once in 2⁷, less than one in a hundred.
constexpr double kFewestPerTrial = 7.0;
constexpr double kSurelyMoves = 0.5;                             // of a range that moved the joint
constexpr double kLargeScatter = 1.0, kNoticeableScatter = 0.2;  // over the motion

bool measures_a_joint(const RobotSpec& robot, const Channel& channel) {
  for (const SensorSpec& sensor : robot.sensors) {
    if (sensor.kind != SensorKind::joint_position && sensor.kind != SensorKind::joint_velocity) continue;
    const std::vector<Channel> channels = sensor_channels(robot, sensor);
    if (std::find(channels.begin(), channels.end(), channel) != channels.end()) return true;
  }
  return false;
}

double deviation_of(const TimeSeries& series, Eigen::Index channel) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (Eigen::Index i = 0; i < series.samples.rows(); ++i) {
    const double value = series.samples(i, channel);
    if (!std::isfinite(value)) continue;
    sum += value;
    squares += value * value;
    count += 1.0;
  }
  return std::sqrt(std::max(squares / count - std::pow(sum / count, 2), 0.0));
}

/// The widest range of a command; 0: nothing is commanded.
double command_range(const Trial& trial) {
  const TimeSeries::Samples& samples = trial.commands.series.samples;
  if (samples.size() == 0) return 0.0;
  return (samples.colwise().maxCoeff() - samples.colwise().minCoeff()).maxCoeff();
}

/// A channel in one trial.
struct Look {
  const Trial& trial;
  const Channel& channel;
  SignalShape shape;
  double scatter = 0.0, motion = 0.0;  ///< RMS, the motion without the scatter
  bool moves() const { return shape.lowest < shape.highest && scatter <= kLargeScatter * motion; }
};

/// Whether the trial should have moved: half as much was commanded as where the same channel did, or it never did. A
/// joint that stands still under less may be held by friction.
bool should_move(const Look& look, const std::vector<Look>& all) {
  const double range = command_range(look.trial);
  double least = std::numeric_limits<double>::infinity();
  for (const Look& other : all)
    if (other.channel == look.channel && other.moves()) least = std::min(least, command_range(other.trial));
  return range > 0.0 && (range >= kSurelyMoves * least || std::isinf(least));
}

Doubt constant_doubt(const Look& look, bool expected) {
  return {expected ? Severity::fault : Severity::note,
          fmt::format("{}: {} is {} from the first sample to the last{}", look.trial.name, look.channel.name,
                      format_quantity(look.shape.lowest, look.channel.unit),
                      expected ? ", though the commands change: if the sensor was not connected, the joint was "
                                 "blocked or its friction is above all that was commanded, leave the file out"
                               : "")};
}

Doubt clipped_doubt(const Look& look, bool is_tried) {
  const SignalShape& shape = look.shape;
  const double limit = shape.clipped_high ? shape.highest : shape.lowest;
  return {is_tried ? Severity::note : Severity::fault,
          fmt::format("{}: {} stays at {} for {:.2g} % of the samples, {} entered and left at full speed: its range "
                      "ended there, and what it did not see looks like a force; mask these times",
                      look.trial.name, look.channel.name, format_quantity(limit, look.channel.unit),
                      100.0 * static_cast<double>(shape.clipped) / static_cast<double>(shape.count),
                      shape.clipped_runs == 1 ? "once," : fmt::format("{} times,", shape.clipped_runs))};
}

Doubt scatter_doubt(const Look& look, bool expected) {
  const bool is_seen = look.motion > 0.1 * look.scatter;
  const std::string moved = is_seen ? "what moves is " + format_quantity(look.motion, look.channel.unit) + " (RMS)"
                                    : "no motion is to be seen beside it";
  const char* advice = "small effects drown in such noise";
  if (!look.moves())
    advice = !expected ? "it tells little but that the joint hardly moved"
             : is_seen
                 ? "the noise is larger than the signal; move further, or measure better"
                 : "the joint is blocked, or its friction is above all that was commanded, or the noise hides how "
                   "it moves; free it, command more, or measure better";
  return {!look.moves() && expected ? Severity::fault : Severity::note,
          fmt::format("{}: {} scatters by {} from sample to sample, and {}: {}", look.trial.name, look.channel.name,
                      format_quantity(look.scatter, look.channel.unit), moved, advice)};
}

std::vector<Look> look_at_all(const DoubtTask& task) {
  std::vector<Look> looks;
  for (const Trial& trial : task.trials) {
    if (trial.held_out) continue;
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c) {
      const Channel& channel = trial.measured.channels[c];
      if (!measures_a_joint(task.definition.structure.robot, channel)) continue;
      const auto column = static_cast<Eigen::Index>(c);
      Look look{trial, channel, shape_of(trial.measured, column), scatter_of(trial.measured, column)};
      const double all = deviation_of(trial.measured, column);
      look.motion = std::sqrt(std::max(all * all - look.scatter * look.scatter, 0.0));
      looks.push_back(look);
    }
  }
  return looks;
}

/// What ends by itself, as a fall or a swing that is let go does, cannot be recorded longer, but again.
Doubt too_little_doubt(double seconds, std::size_t trials, bool driven) {
  const double least = kStretch * kFewestPerTrial;
  const auto stretches = static_cast<std::size_t>(seconds / kStretch);
  const double times = std::ceil(least / seconds * static_cast<double>(trials));
  const std::string advice =
      driven ? fmt::format("Record {} s at least, in one file or several; better ten times as much", least)
             : fmt::format(
                   "Nothing drives this motion: if it ends by itself, record it {:.0f} times or more, from other "
                   "starts and at a higher rate; else record {} s at least",
                   times, least);
  return {
      Severity::too_little,
      fmt::format("the fit files hold {:.3g} s, {} of {} s, which limits what they can tell: so few agree by chance "
                  "too often. {}",
                  seconds, stretches == 1 ? "1 stretch" : fmt::format("{} stretches", stretches), kStretch, advice)};
}

}  // namespace

std::vector<Doubt> amount_doubts(const DoubtTask& task) {
  std::vector<Doubt> doubts;
  double seconds = 0.0;
  std::size_t fitted = 0;
  bool driven = false;
  const Trial* only = nullptr;
  for (const Trial& trial : task.trials) {
    if (trial.held_out || trial.measured.times.size() == 0) continue;
    ++fitted;
    only = &trial;
    driven = driven || command_range(trial) > 0.0;
    seconds += trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0);
  }
  if (fitted == 0) return doubts;
  if (seconds < kStretch * kFewestPerTrial - 1e-9) doubts.push_back(too_little_doubt(seconds, fitted, driven));
  if (fitted == 1)
    doubts.push_back({Severity::note,
                      fmt::format("{} is the only file to fit to: models are judged on parts of it that they were not "
                                  "fitted to, which is weaker than on another file",
                                  only->name)});
  if (fitted == task.trials.size())
    doubts.push_back(
        {Severity::note,
         "nothing is held out: the evidence is cross-validation inside the fit files, which the search has "
         "seen and which is weaker; name a file under holdout, and compare and history check the answer on it"});
  return doubts;
}

std::vector<Doubt> channel_doubts(const DoubtTask& task) {
  std::vector<Doubt> doubts;
  const std::vector<Look> looks = look_at_all(task);
  for (const Look& look : looks) {
    if (look.shape.count == 0) {
      doubts.push_back({Severity::note, fmt::format("{}: {} has no value", look.trial.name, look.channel.name)});
    } else if (look.shape.lowest == look.shape.highest) {
      doubts.push_back(constant_doubt(look, should_move(look, looks)));
    } else {
      if (look.shape.clipped > 0) doubts.push_back(clipped_doubt(look, task.saturation_is_tried));
      if (look.scatter > kNoticeableScatter * look.motion && command_range(look.trial) > 0.0)
        doubts.push_back(scatter_doubt(look, should_move(look, looks)));
    }
  }
  return doubts;
}

bool is_saturated(const RobotSpec& robot, const Trial& trial) {
  for (std::size_t c = 0; c < trial.measured.channels.size(); ++c)
    if (measures_a_joint(robot, trial.measured.channels[c]) &&
        shape_of(trial.measured, static_cast<Eigen::Index>(c)).clipped > 0)
      return true;
  return false;
}

}  // namespace lacuna
