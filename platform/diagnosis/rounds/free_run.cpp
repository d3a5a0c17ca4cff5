#include "diagnosis/rounds/free_run.h"

#include "diagnosis/noise/contact_doubt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr double kLost = 1.0 / 3.0;               ///< of a channel's deviation
constexpr double kBin = 0.025, kTouchBin = 0.05;  ///< s
constexpr double kWhole = 0.95;                   ///< of all blocks: as good as whole trials

bool is_touch(const RobotSpec& robot, const std::string& channel) {
  return std::any_of(robot.sensors.begin(), robot.sensors.end(), [&](const SensorSpec& sensor) {
    return sensor.kind == SensorKind::touch && sensor.name == channel;
  });
}

/// A value of two that changes says when it changed: its bins are so wide that a small change of the moment shows in
/// one of them in proportion.
std::vector<double> widths(const RobotSpec& robot, const std::vector<ChannelNoise>& noise) {
  std::vector<double> all;
  for (const ChannelNoise& channel : noise) all.push_back(is_touch(robot, channel.channel) ? kTouchBin : kBin);
  return all;
}

/// Pieces of one run: all begin where it begins, each counts the rows of its own time.
void add_blocks(const Segment& run, const Trial& trial, double length, std::vector<Segment>& blocks) {
  for (const Stretch& piece : cut(trial, run.stretch.trial, length)) {
    Segment block = run;
    block.stretch.last = piece.last;
    block.rows.clear();
    block.columns.clear();
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
      if (run.rows[i] < piece.first || run.rows[i] >= piece.last) continue;
      block.rows.push_back(run.rows[i]);
      block.columns.push_back(run.columns[i]);
    }
    if (block.rows.size() > block.unknown.size()) blocks.push_back(std::move(block));
  }
}

/// Standard deviation of what each channel reads, in units of its noise.
std::vector<double> motions(const BaseSolution& base) {
  std::vector<double> all;
  for (const ChannelNoise& noise : base.noise) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (const Trial& trial : base.trials)
      for (std::size_t c = 0; c < trial.measured.channels.size(); ++c) {
        if (trial.measured.channels[c].name != noise.channel) continue;
        for (const double value : trial.measured.samples.col(static_cast<Eigen::Index>(c))) {
          if (!std::isfinite(value)) continue;
          sum += value;
          squares += value * value;
          count += 1.0;
        }
      }
    const double mean = sum / std::max(count, 1.0);
    all.push_back(std::sqrt(std::max(0.0, squares / std::max(count, 1.0) - mean * mean)) / noise.deviation);
  }
  return all;
}

/// Mean over the channels that move of how much of their motion is doubtful in a block.
double lost(const std::vector<RowBins::Bin>& bins, const Eigen::MatrixXd& doubt, const std::vector<double>& motion) {
  const Eigen::VectorXd variance = doubt.rowwise().squaredNorm() / static_cast<double>(doubt.cols());
  std::vector<double> squares(motion.size(), 0.0), counts(motion.size(), 0.0);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    squares[bins[i].channel] += variance(static_cast<Eigen::Index>(i));
    counts[bins[i].channel] += 1.0;
  }
  double sum = 0.0, moving = 0.0;
  for (std::size_t c = 0; c < motion.size(); ++c) {
    if (counts[c] == 0.0 || motion[c] <= 1.0) continue;
    sum += std::sqrt(squares[c] / counts[c]) / motion[c];
    moving += 1.0;
  }
  return moving > 0.0 ? sum / moving : 0.0;
}

double block_of(const CutTask& task) { return task.segment > 0.0 ? task.segment : kUsualBlock; }  // s

/// Which blocks are predicted: of each trial those before the first that is not.
std::vector<bool> predicted(const CutTask& task, const TrialPredictor& predictor, const BaseSolution& base) {
  const ParameterSpace space(task.definition.free);
  const RowBins bins(ShootingProblem(predictor, space, base.segments, base.noise), base.bin_widths);
  const std::vector<Eigen::MatrixXd> doubts = contact_doubts(task.definition, base, bins, task.threads);
  const std::vector<double> motion = motions(base);
  std::set<std::size_t> ended;
  std::vector<bool> kept;
  for (std::size_t k = 0; k < base.segments.size(); ++k) {
    const std::size_t trial = base.segments[k].stretch.trial;
    if (lost(bins.bins(k), doubts[k], motion) > kLost) ended.insert(trial);
    kept.push_back(!ended.contains(trial));
  }
  return kept;
}

double seconds(const Trial& trial, Eigen::Index last) {
  return trial.measured.times(last - 1) - trial.measured.times(0);
}

/// Of the trials: how much of each is used, and why no more.
std::string remark(const BaseSolution& base, const std::string& obstacle) {
  double used = 0.0, all = 0.0, shortest = kInfinity, longest = 0.0;
  for (std::size_t trial = 0; trial < base.trials.size(); ++trial) {
    double until = 0.0;
    for (const Segment& block : base.segments)
      if (block.stretch.trial == trial) until = std::max(until, seconds(base.trials[trial], block.stretch.last));
    const double whole = seconds(base.trials[trial], base.trials[trial].measured.times.size());
    used += until;
    all += whole;
    if (until > 0.0) shortest = std::min(shortest, until);
    longest = std::max(longest, until);
  }
  const std::string start = fmt::format("free runs from the start, since {}", obstacle);
  if (used > kWhole * all) return start + ": whole trials";
  return fmt::format(
      "{}: the first {:.2g} to {:.2g} s of a trial, {:.3g} of {:.3g} s in all; beyond, shorter steps or slightly "
      "other contacts change the prediction by more than a third of the motion, and it tells nothing. More short "
      "trials tell more than longer ones",
      start, shortest, longest, used, all);
}

void keep(const std::vector<bool>& kept, std::vector<Segment>& segments) {
  std::vector<Segment> all;
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (kept[k]) all.push_back(std::move(segments[k]));
  segments = std::move(all);
}

}  // namespace

void cut_free_runs(const CutTask& task, const TrialPredictor& predictor, const StartStates& states,
                   BaseSolution& base) {
  base.free_run = true;
  base.values = task.values;
  base.segment = block_of(task);
  base.bin_widths = widths(task.definition.structure.robot, base.noise);
  for (Segment& run : make_segments(predictor, states, 0.0, task.values, kLongestMemory)) {
    run.deviation *= kDoubtOfStart;
    add_blocks(run, base.trials[run.stretch.trial], block_of(task), base.segments);
  }
  if (base.segments.empty()) return;
  const ParameterSpace space(task.definition.free);
  base.states =
      ShootingProblem(predictor, space, base.segments, base.noise).start(space.to_coordinates(task.values)).states;
  std::vector<bool> kept = predicted(task, predictor, base);
  if (std::find(kept.begin(), kept.end(), true) == kept.end()) {
    base.remarks.push_back(
        fmt::format("not even the first {:.2g} s of a trial are predicted: shorter steps or slightly other contacts "
                    "change them by more than a third of the motion. Softer contacts (engine.contact) or slower "
                    "commands would help",
                    block_of(task)));
    for (std::size_t k = 0; k < kept.size(); ++k)
      kept[k] = k == 0 || base.segments[k].stretch.trial != base.segments[k - 1].stretch.trial;
  }
  keep(kept, base.segments);
  if (!base.remarks.empty()) return;
  std::string obstacle;
  for (std::size_t trial = 0; trial < base.trials.size() && obstacle.empty(); ++trial)
    obstacle = states.obstacle(trial);
  base.remarks.push_back(remark(base, obstacle));
}

}  // namespace lacuna
