#include "horizons/ladder.h"

#include "foundation/address.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

constexpr double kShortest = 10.0;  ///< samples
constexpr int kRungs = 5;
constexpr double kMostOfStart = 0.25;  ///< of the motion's power
constexpr double kStandsOut = 9.0;     ///< motion over floor, variances
constexpr double kSlack = 2.0;         ///< prior deviations of a start that is refitted, times its own
constexpr std::size_t kMostForShare = 48;
constexpr double kShareOfQuick = 0.2;  ///< of a rung's segments, for a first look
constexpr std::size_t kSegmentsOfQuick = 6;
constexpr std::size_t kMostSegments = 60;  ///< of a rung, evenly spread: more tell hardly more
constexpr double kMostSamples = 4000.0;
constexpr std::size_t kFewSegments = 2;  ///< which are kept however long they are
constexpr double kLongest = 3000.0;      ///< samples of a horizon: longer ones cost more time than they tell
constexpr double kFewCoordinates = 2.0;  ///< of a robot: each further one costs time, and is read as well
constexpr std::size_t kSamplesOfQuick = 3000;
constexpr double kShortestTrial = 0.7;  ///< of a rung's length: a shorter trial says nothing of it

std::vector<std::size_t> trials_of(const LadderTask& task) {
  std::vector<std::size_t> trials;
  for (std::size_t t = 0; t < task.predictor.trials().size(); ++t)
    if (task.predictor.trials()[t].held_out == task.held_out) trials.push_back(t);
  return trials;
}

double duration(const Trial& trial) {
  return trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0);
}

double median_interval(const std::vector<Trial>& trials, Eigen::Index channel) {
  std::vector<double> steps;
  for (const Trial& trial : trials) {
    double before = std::nan("");
    for (Eigen::Index i = 0; i < trial.measured.times.size(); ++i) {
      if (channel >= trial.measured.samples.cols() || std::isnan(trial.measured.samples(i, channel))) continue;
      if (!std::isnan(before)) steps.push_back(trial.measured.times(i) - before);
      before = trial.measured.times(i);
    }
  }
  if (steps.empty()) return 0.0;
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

/// A segment whose start the data tell; refitted within its uncertainty where `refits`.
Segment segment_of(const LadderTask& task, const Stretch& counted, double run_in, bool refits) {
  const Trial& trial = task.predictor.trials()[counted.trial];
  const Eigen::VectorXd& times = trial.measured.times;
  Segment segment;
  segment.stretch = counted;
  if (run_in > 0.0 && counted.first > 0) {
    const double* before =
        std::lower_bound(times.data(), times.data() + counted.first, times(counted.first) - run_in * (1.0 + 1e-9));
    const Eigen::Index first = std::min<Eigen::Index>(before - times.data(), counted.first - 1);
    segment.warm_up = WarmUp{first, task.starts.at(counted.trial, first).start};
  }
  const StartEstimate estimate = task.starts.at(counted.trial, counted.first);
  segment.start = estimate.start;
  std::vector<double> deviation;
  for (int index = 0; refits && index < 2 * task.states.coordinates(); ++index) {
    if (!estimate.tells(index)) continue;
    segment.unknown.push_back(index);
    deviation.push_back(kSlack * estimate.deviation(index));
  }
  segment.deviation = Eigen::Map<Eigen::VectorXd>(deviation.data(), static_cast<Eigen::Index>(deviation.size()));
  for (Eigen::Index row = 0; row < segment.stretch.size(); ++row)
    for (Eigen::Index column = 0; column < trial.measured.samples.cols(); ++column)
      if (std::isfinite(trial.measured.samples(segment.stretch.first + row, column))) {
        segment.rows.push_back(row);
        segment.columns.push_back(column);
      }
  return segment;
}

std::size_t samples_of(const std::vector<Segment>& segments) {
  std::size_t samples = 0;
  for (const Segment& segment : segments) samples += static_cast<std::size_t>(segment.stretch.size());
  return samples;
}

/// By how much fewer samples are predicted of a robot that has many coordinates.
double share_of_samples(const StartStates& states) {
  return std::min(1.0, kFewCoordinates / static_cast<double>(states.coordinates()));
}

std::vector<Segment> not_too_many(const LadderTask& task, std::vector<Segment> segments) {
  const std::size_t samples = samples_of(segments);
  if (samples == 0) return segments;
  const double share = share_of_samples(task.states) * kMostSamples / static_cast<double>(samples);
  const auto wanted = std::max(kFewSegments, static_cast<std::size_t>(share * static_cast<double>(segments.size())));
  return thinned(std::move(segments), std::min(kMostSegments, wanted));
}

/// A body in the air or on the ground: between two readings it may hit something, so that only where a recording begins
/// do the readings around a sample tell its state.
bool starts_in_flight(const RobotSpec& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [](const JointSpec& joint) { return joint.kind == JointKind::free; });
}

std::vector<Segment> segments_of(const LadderTask& task, double length, bool refits) {
  const double run_in = task.predictor.model().has_memory() ? kLongestMemory : 0.0;
  std::vector<Segment> segments;
  for (const std::size_t t : trials_of(task)) {
    const Trial& trial = task.predictor.trials()[t];
    if (duration(trial) < kShortestTrial * length) continue;
    for (const Stretch& stretch : cut(trial, t, length)) {
      if (stretch.first > 0 && starts_in_flight(task.robot)) break;
      Segment segment = segment_of(task, stretch, run_in, refits);
      if (segment.rows.size() > segment.unknown.size() + 3) segments.push_back(std::move(segment));
    }
  }
  return not_too_many(task, std::move(segments));
}

std::map<std::string, std::size_t> index_of_channels(const std::vector<ChannelNoise>& channels) {
  std::map<std::string, std::size_t> index;
  for (std::size_t c = 0; c < channels.size(); ++c) index[channels[c].channel] = c;
  return index;
}

/// Sums over the rows of segments, by channel.
struct Sums {
  std::vector<double> share, motion, noise, count;
  explicit Sums(std::size_t channels) : share(channels), motion(channels), noise(channels), count(channels) {}
};

void add_motion(const LadderTask& task, const Segment& segment, const std::map<std::string, std::size_t>& index,
                Sums& sums) {
  const TimeSeries& measured = task.predictor.trials()[segment.stretch.trial].measured;
  std::vector<double> first(static_cast<std::size_t>(measured.samples.cols()), std::nan(""));
  for (std::size_t r = 0; r < segment.rows.size(); ++r) {
    const auto column = static_cast<std::size_t>(segment.columns[r]);
    const double value = measured.samples(segment.stretch.first + segment.rows[r], segment.columns[r]);
    if (std::isnan(first[column])) first[column] = value;
    const std::size_t c = index.at(measured.channels[column].name);
    sums.motion[c] += std::pow(value - first[column], 2);
    double noise = task.starts.reading_noise(segment.stretch.trial, segment.columns[r]);
    if (std::isnan(noise)) noise = task.noise[c].deviation;
    sums.noise[c] += noise * noise;
    sums.count[c] += 1.0;
  }
}

/// Adds the variance of a prediction by its start's uncertainty, to first order.
void add_start_share(const LadderTask& task, const Segment& segment, const std::map<std::string, std::size_t>& index,
                     std::vector<double>& share, std::vector<double>& count) {
  const TimeSeries& measured = task.predictor.trials()[segment.stretch.trial].measured;
  const StartEstimate estimate = task.starts.at(segment.stretch.trial, segment.stretch.first);
  Prediction plain, moved;
  task.predictor.predict(segment.stretch, task.values, segment.start, 0, plain);
  if (!plain.valid) return;
  for (std::size_t r = 0; r < segment.rows.size(); ++r)
    count[index.at(measured.channels[static_cast<std::size_t>(segment.columns[r])].name)] += 1.0;
  for (Eigen::Index axis = 0; axis < estimate.axes.cols(); ++axis) {
    if (estimate.axes.col(axis).isZero()) continue;
    task.predictor.predict(segment.stretch, task.values, moved_along(estimate, axis), 0, moved);
    if (!moved.valid) continue;
    for (std::size_t r = 0; r < segment.rows.size(); ++r) {
      const double change =
          moved.samples(segment.rows[r], segment.columns[r]) - plain.samples(segment.rows[r], segment.columns[r]);
      share[index.at(measured.channels[static_cast<std::size_t>(segment.columns[r])].name)] += change * change;
    }
  }
}

Rung rung_of(const LadderTask& task, double length, bool refits) {
  Rung rung;
  rung.length = length;
  rung.segments = segments_of(task, length, refits);
  const auto index = index_of_channels(task.noise);
  Sums sums(task.noise.size());
  for (const Segment& segment : rung.segments) add_motion(task, segment, index, sums);
  std::vector<double> share(task.noise.size()), count(task.noise.size());
  for (const Segment& segment : thinned(rung.segments, kMostForShare))
    add_start_share(task, segment, index, share, count);
  for (std::size_t c = 0; c < task.noise.size(); ++c) {
    const double n = std::max(1.0, sums.count[c]);
    rung.start_share.push_back(count[c] > 0.0 ? share[c] / count[c] : 0.0);
    rung.motion.push_back(sums.motion[c] / n);
    rung.floor.push_back(sums.noise[c] / n + rung.start_share.back());
    rung.counts.push_back(sums.count[c] > 0.0 && rung.motion.back() > kStandsOut * rung.floor.back());
  }
  return rung;
}

/// Whether the starts leave the predictions their meaning, in every channel that moves.
bool means_something(const Rung& rung) {
  for (std::size_t c = 0; c < rung.motion.size(); ++c)
    if (rung.motion[c] > 0.0 && rung.start_share[c] > kMostOfStart * rung.motion[c]) return false;
  return !rung.segments.empty();
}

/// Each joint weighs the same, however many channels read it; a sensor that reads no joint counts as one.
void weigh(const RobotSpec& robot, Ladder& ladder) {
  std::map<std::string, std::string> group_of;
  for (const SensorSpec& sensor : robot.sensors)
    for (const Channel& channel : sensor_channels(robot, sensor)) group_of[channel.name] = sensor.element;
  std::map<std::string, double> cells;
  for (const Rung& rung : ladder.rungs)
    for (std::size_t c = 0; c < ladder.channels.size(); ++c)
      if (rung.counts[c]) cells[group_of[ladder.channels[c].channel]] += 1.0;
  for (Rung& rung : ladder.rungs) {
    rung.weight.assign(ladder.channels.size(), 0.0);
    for (std::size_t c = 0; c < ladder.channels.size(); ++c)
      if (rung.counts[c])
        rung.weight[c] = 1.0 / (cells[group_of[ladder.channels[c].channel]] * static_cast<double>(cells.size()));
  }
}

}  // namespace

Ladder build_ladder(const LadderTask& task) {
  Ladder ladder;
  ladder.channels = task.noise;
  double longest = 0.0, interval = std::numeric_limits<double>::infinity();
  // A length that no held-out trial has could not be judged.
  double longest_held_out = 0.0;
  for (const Trial& trial : task.predictor.trials())
    (trial.held_out ? longest_held_out : longest) =
        std::max(trial.held_out ? longest_held_out : longest, duration(trial));
  if (longest_held_out > 0.0) longest = std::min(longest, longest_held_out);
  for (Eigen::Index c = 0; c < static_cast<Eigen::Index>(task.noise.size()); ++c)
    if (const double own = median_interval(task.predictor.trials(), c); own > 0.0) interval = std::min(interval, own);
  longest = std::min(longest, share_of_samples(task.states) * kLongest * interval);
  const double shortest = std::min(kShortest * interval, longest / 3.0);
  double length = longest;
  Rung last = rung_of(task, length, true);
  while (!means_something(last) && length > 1.5 * shortest) last = rung_of(task, length *= 0.7, true);
  ladder.ended_by_starts = length < longest;
  const double ratio = std::pow(length / shortest, 1.0 / (kRungs - 1));
  const int rungs = ratio < 1.5 ? 3 : kRungs;
  for (int k = 0; k + 1 < rungs; ++k)
    ladder.rungs.push_back(rung_of(task, shortest * std::pow(length / shortest, k / (rungs - 1.0)), false));
  ladder.rungs.push_back(std::move(last));
  weigh(task.robot, ladder);
  return ladder;
}

Ladder same_ladder(const Ladder& ladder, const LadderTask& task) {
  Ladder same = ladder;
  for (std::size_t k = 0; k < same.rungs.size(); ++k)
    same.rungs[k].segments = segments_of(task, same.rungs[k].length, !task.held_out && k + 1 == same.rungs.size());
  return same;
}

Ladder thinned(const Ladder& ladder, double share, std::size_t least) {
  Ladder few = ladder;
  for (Rung& rung : few.rungs) {
    const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(rung.segments.size())));
    rung.segments = thinned(std::move(rung.segments), std::max(wanted, least));
  }
  return few;
}

Ladder quick(const Ladder& ladder) {
  Ladder few = thinned(first_rungs(ladder, ladder.rungs.size() - 1), kShareOfQuick, kSegmentsOfQuick);
  for (Rung& rung : few.rungs) {
    const std::size_t samples = samples_of(rung.segments);
    if (samples <= kSamplesOfQuick) continue;
    const std::size_t most = std::max<std::size_t>(1, kSamplesOfQuick * rung.segments.size() / samples);
    rung.segments = thinned(std::move(rung.segments), most);
  }
  return few;
}

Ladder first_rungs(const Ladder& ladder, std::size_t count) {
  Ladder part = ladder;
  part.rungs.resize(count);
  return part;
}

std::size_t channel_index(const Ladder& ladder, const Trial& trial, Eigen::Index column) {
  const std::string& name = trial.measured.channels[static_cast<std::size_t>(column)].name;
  std::size_t c = 0;
  while (ladder.channels[c].channel != name) ++c;
  return c;
}

std::vector<Segment> all_segments(const Ladder& ladder) {
  std::vector<Segment> all;
  for (const Rung& rung : ladder.rungs) all.insert(all.end(), rung.segments.begin(), rung.segments.end());
  return all;
}

}  // namespace lacuna
