#include "data_checks/channel_checks.h"

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

constexpr double kStretch = 0.5;  // s, length of the stretches of a diagnosis
/// All of so many stretches favour a model by chance once in 2⁷ cases, below one in a hundred.
constexpr double kFewestPerTrial = 7.0;
constexpr double kSurelyMoves = 0.5;                             // of the smallest command range that moved the joint
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

/// The widest range of a command; 0: there are no commands.
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
  double scatter = 0.0, motion = 0.0;  ///< RMS of the motion, without the scatter
  bool moves() const { return shape.lowest < shape.highest && scatter <= kLargeScatter * motion; }
};

/// Whether the trial should have moved: its commands reach half of the range that moved the same channel elsewhere, or
/// the channel never moved. Friction may hold a joint under smaller commands.
bool should_move(const Look& look, const std::vector<Look>& all) {
  const double range = command_range(look.trial);
  double least = std::numeric_limits<double>::infinity();
  for (const Look& other : all)
    if (other.channel == look.channel && other.moves()) least = std::min(least, command_range(other.trial));
  return range > 0.0 && (range >= kSurelyMoves * least || std::isinf(least));
}

DataWarning constant_doubt(const Look& look, bool expected) {
  return {expected ? Severity::fault : Severity::note,
          fmt::format("{}: {} stays at {} from the first sample to the last{}", look.trial.name, look.channel.name,
                      format_quantity(look.shape.lowest, look.channel.unit),
                      expected ? ", although the commands change; leave the file out if the sensor was not connected, "
                                 "the joint was blocked, or the commands were below its friction"
                               : "")};
}

DataWarning clipped_doubt(const Look& look, bool is_tried) {
  const SignalShape& shape = look.shape;
  const double limit = shape.clipped_high ? shape.highest : shape.lowest;
  return {is_tried ? Severity::note : Severity::fault,
          fmt::format("{}: {} stays at {} for {:.2g} % of the samples, {} entered and left at full speed: the sensor "
                      "reached the end of its range, and the missing motion looks like a force; mask these times",
                      look.trial.name, look.channel.name, format_quantity(limit, look.channel.unit),
                      100.0 * static_cast<double>(shape.clipped) / static_cast<double>(shape.count),
                      shape.clipped_runs == 1 ? "once," : fmt::format("{} times,", shape.clipped_runs))};
}

DataWarning scatter_doubt(const Look& look, bool expected) {
  const bool is_seen = look.motion > 0.1 * look.scatter;
  const std::string moved = is_seen ? "the motion is " + format_quantity(look.motion, look.channel.unit) + " (RMS)"
                                    : "no motion is visible in it";
  const char* advice = "small effects cannot be seen in such noise";
  if (!look.moves())
    advice = !expected ? "it shows only that the joint hardly moved"
             : is_seen ? "the noise is larger than the signal; use larger motions or a better sensor"
                       : "the joint is blocked, its friction exceeds the commands, or the noise hides its motion; free "
                         "the joint, use larger commands or a better sensor";
  return {!look.moves() && expected ? Severity::fault : Severity::note,
          fmt::format("{}: the noise of {} from sample to sample is {}, and {}: {}", look.trial.name, look.channel.name,
                      format_quantity(look.scatter, look.channel.unit), moved, advice)};
}

std::vector<Look> look_at_all(const DataCheckTask& task) {
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

/// A motion that ends by itself, such as a fall or a free swing, can be recorded again but not for longer.
DataWarning too_little_doubt(double seconds, std::size_t trials, bool driven) {
  const double least = kStretch * kFewestPerTrial;
  const auto stretches = static_cast<std::size_t>(seconds / kStretch);
  const double times = std::ceil(least / seconds * static_cast<double>(trials));
  const std::string advice =
      driven ? fmt::format("Record {} s or more, in one file or several; ten times as much is better", least)
             : fmt::format(
                   "These recordings have no commands: if the motion ends by itself, record it {:.0f} times or more, "
                   "from other initial states and at a higher rate; else record {} s or more",
                   times, least);
  return {Severity::too_little,
          fmt::format(
              "too little data: the fit files have {:.3g} s, {} of {} s. With fewer than {:g} segments, chance alone "
              "often makes all of them favour the same wrong model. {}",
              seconds, stretches == 1 ? "1 segment" : fmt::format("{} segments", stretches), kStretch, kFewestPerTrial,
              advice)};
}

}  // namespace

std::vector<DataWarning> amount_doubts(const DataCheckTask& task) {
  std::vector<DataWarning> doubts;
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
    doubts.push_back({Severity::note, fmt::format("{} is the only fit file: models are evaluated on parts of it that "
                                                  "they were not fitted to, which is weaker evidence than another file",
                                                  only->name)});
  if (fitted == task.trials.size())
    doubts.push_back(
        {Severity::note,
         "no file is held out: the evidence is cross-validation within the fit files, which the search has used, and "
         "is weaker; name a file under holdout, and check the answer on it with compare and history check"});
  return doubts;
}

std::vector<DataWarning> channel_checks(const DataCheckTask& task) {
  std::vector<DataWarning> doubts;
  const std::vector<Look> looks = look_at_all(task);
  for (const Look& look : looks) {
    if (look.shape.count == 0) {
      doubts.push_back({Severity::note, fmt::format("{}: {} has no values", look.trial.name, look.channel.name)});
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
