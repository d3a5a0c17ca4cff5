#include "prediction/prediction_ladder.h"

#include "fitting/starts/segments.h"
#include "foundation/address.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace lacuna {
namespace {

constexpr std::size_t kBlocks = 40;
constexpr std::size_t kFolds = 3;
constexpr double kShortestTrial = 0.7;       ///< of a length: shorter trials are left out
constexpr std::size_t kFewestOfALength = 2;  ///< stretches

/// Blocks of time by trial and sample.
struct TimeBlocksOfTrials {
  std::vector<std::vector<std::size_t>> of_sample;
  std::size_t count = 0;
  std::vector<std::size_t> trial_of_block;
};

TimeBlocksOfTrials blocks_of(const std::vector<Trial>& trials, bool held_out) {
  std::size_t total = 0;
  for (const Trial& trial : trials)
    if (trial.held_out == held_out) total += static_cast<std::size_t>(trial.measured.times.size());
  const std::size_t size = std::max<std::size_t>(1, (total + kBlocks - 1) / kBlocks);
  TimeBlocksOfTrials blocks;
  std::size_t trial_number = 0;
  for (const Trial& trial : trials) {
    std::vector<std::size_t>& own = blocks.of_sample.emplace_back();
    if (trial.held_out != held_out) continue;
    const auto samples = static_cast<std::size_t>(trial.measured.times.size());
    const std::size_t pieces = (samples + size - 1) / size;
    for (std::size_t i = 0; i < samples; ++i) own.push_back(blocks.count + std::min(i * pieces / samples, pieces - 1));
    blocks.count += pieces;
    blocks.trial_of_block.resize(blocks.count, trial_number++);
  }
  return blocks;
}

void set_folds(const TimeBlocksOfTrials& blocks, CellLayout& layout) {
  const std::size_t trials = blocks.trial_of_block.empty() ? 0 : blocks.trial_of_block.back() + 1;
  layout.folds = std::max(trials, kFolds);
  for (std::size_t b = 0; b < blocks.count; ++b)
    layout.fold_of_block.push_back(trials >= kFolds ? blocks.trial_of_block[b] : b * kFolds / blocks.count);
}

/// For a body in the air or on the ground, or if some position is not read, the readings determine the state only at
/// the beginning of a recording.
bool starts_at_the_beginning_alone(const LadderSource& source, std::size_t trial) {
  const auto floats = [](const JointSpec& joint) { return joint.kind == JointKind::free; };
  const std::vector<JointSpec>& joints = source.robot.joints;
  return std::any_of(joints.begin(), joints.end(), floats) || has_floating_body(source.robot) ||
         !source.states.unmeasured(trial).empty();
}

std::map<std::string, std::size_t> index_of(const std::vector<ChannelNoise>& noise) {
  std::map<std::string, std::size_t> index;
  for (std::size_t c = 0; c < noise.size(); ++c) index[noise[c].channel] = c;
  return index;
}

/// `blocks`: by sample of the trial.
void add_readings(const TimeSeries& measured, const std::vector<std::size_t>& blocks,
                  const std::map<std::string, std::size_t>& channel_index, PredictedStretch& result) {
  const Stretch& stretch = result.stretch;
  for (Eigen::Index row = 1; row < stretch.size(); ++row)
    for (Eigen::Index column = 0; column < measured.samples.cols(); ++column) {
      if (!std::isfinite(measured.samples(stretch.first + row, column))) continue;
      result.rows.push_back(row);
      result.columns.push_back(column);
      result.channels.push_back(channel_index.at(measured.channels[static_cast<std::size_t>(column)].name));
      result.blocks.push_back(blocks[static_cast<std::size_t>(stretch.first + row)]);
    }
}

PredictedStretch stretch_from(const LadderSource& source, const Stretch& stretch, std::size_t length,
                              const std::vector<std::size_t>& blocks,
                              const std::map<std::string, std::size_t>& channel_index) {
  const TimeSeries& measured = source.predictor.trials()[stretch.trial].measured;
  const StartEstimate estimate = source.starts.at(stretch.trial, stretch.first);
  PredictedStretch result;
  result.stretch = stretch;
  result.length = length;
  result.start = estimate.start;
  for (int index = 0; index < 2 * source.states.coordinates(); ++index)
    if (estimate.tells(index)) result.unknown.push_back(index);
  const Eigen::MatrixXd whole = estimate.axes * estimate.axes.transpose();
  const auto size = static_cast<Eigen::Index>(result.unknown.size());
  result.covariance.resize(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      result.covariance(i, j) =
          whole(result.unknown[static_cast<std::size_t>(i)], result.unknown[static_cast<std::size_t>(j)]);
  add_readings(measured, blocks, channel_index, result);
  return result;
}

/// Each stretch contains the first sample of the next one as its end.
std::vector<Stretch> tiles(const LadderSource& source, double length) {
  std::vector<Stretch> all;
  const std::vector<Trial>& trials = source.predictor.trials();
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const Eigen::VectorXd& times = trials[t].measured.times;
    if (trials[t].held_out != source.held_out || times(times.size() - 1) - times(0) < kShortestTrial * length) continue;
    for (Stretch stretch : cut(trials[t], t, length)) {
      if (stretch.first > 0 && starts_at_the_beginning_alone(source, t)) break;
      stretch.last = std::min<Eigen::Index>(stretch.last + 1, times.size());
      if (stretch.size() > 2) all.push_back(stretch);
    }
  }
  return all;
}

std::vector<Stretch> spread(std::vector<Stretch> all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<Stretch> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(all[i * all.size() / most]);
  return kept;
}

/// The cells of each joint have the same total weight.
void set_weights(const RobotSpec& robot, PredictionLadder& ladder) {
  const std::vector<std::string> joints = joints_of(robot, ladder.noise);
  std::vector<bool> is_read(ladder.layout.cells.size(), false);
  for (const PredictedStretch& stretch : ladder.stretches)
    for (const std::size_t channel : stretch.channels) is_read[ladder.cell(stretch.length, channel)] = true;
  std::map<std::string, double> count;
  for (std::size_t i = 0; i < is_read.size(); ++i)
    if (is_read[i]) count[joints[i % ladder.noise.size()]] += 1.0;
  for (std::size_t i = 0; i < is_read.size(); ++i)
    ladder.layout.cells[i].weight =
        is_read[i] ? 1.0 / (static_cast<double>(count.size()) * count[joints[i % ladder.noise.size()]]) : 0.0;
}

}  // namespace

std::vector<std::string> joints_of(const RobotSpec& robot, const std::vector<ChannelNoise>& noise) {
  std::map<std::string, std::string> element;
  for (const SensorSpec& sensor : robot.sensors)
    for (const Channel& channel : sensor_channels(robot, sensor)) element[channel.name] = sensor.element;
  std::vector<std::string> joints;
  for (const ChannelNoise& channel : noise) joints.push_back(element[channel.channel]);
  return joints;
}

PredictionLadder ladder_of(const LadderSource& source, std::vector<double> lengths, std::size_t most) {
  PredictionLadder ladder{std::move(lengths), {}, source.noise, {}};
  const TimeBlocksOfTrials blocks = blocks_of(source.predictor.trials(), source.held_out);
  set_folds(blocks, ladder.layout);
  ladder.layout.lengths = ladder.lengths.size();
  const std::map<std::string, std::size_t> channel_index = index_of(ladder.noise);
  for (std::size_t h = 0; h < ladder.lengths.size(); ++h) {
    for (std::size_t c = 0; c < ladder.noise.size(); ++c) ladder.layout.cells.push_back({h, 0.0});
    for (const Stretch& stretch : spread(tiles(source, ladder.lengths[h]), most)) {
      PredictedStretch one = stretch_from(source, stretch, h, blocks.of_sample[stretch.trial], channel_index);
      if (one.covariance.allFinite())
        ladder.stretches.push_back(std::move(one));  // else the readings do not determine it
    }
  }
  set_weights(source.robot, ladder);
  return ladder;
}

PredictionLadder ladder_of_pairs(const LadderSource& source, const std::vector<Trial>& pairs, Eigen::Index stride,
                                 double length) {
  PredictionLadder ladder{{length}, {}, source.noise, {}};
  ladder.layout = {std::vector<Cell>(ladder.noise.size()), 1, {0}, 1};
  const std::map<std::string, std::size_t> channel_index = index_of(ladder.noise);
  for (std::size_t t = 0; t < pairs.size(); ++t) {
    const std::vector<std::size_t> one_block(static_cast<std::size_t>(pairs[t].measured.times.size()), 0);
    for (Eigen::Index first = 0; !pairs[t].held_out && first < pairs[t].measured.times.size(); first += 2) {
      PredictedStretch pair;
      pair.stretch = {t, first, first + 2};
      pair.start = source.starts.at(t, first / 2 * stride).start;
      add_readings(pairs[t].measured, one_block, channel_index, pair);
      ladder.stretches.push_back(std::move(pair));
    }
  }
  set_weights(source.robot, ladder);
  return ladder;
}

PredictionLadder shorter(const PredictionLadder& ladder, std::size_t count) {
  PredictionLadder part = ladder;
  count = std::min(count, ladder.lengths.size());
  part.lengths.resize(count);
  part.layout.lengths = count;
  part.layout.cells.resize(count * ladder.noise.size());
  std::erase_if(part.stretches, [&](const PredictedStretch& stretch) { return stretch.length >= count; });
  double sum = 0.0;
  for (const Cell& cell : part.layout.cells) sum += cell.weight;
  for (Cell& cell : part.layout.cells) cell.weight /= sum;
  return part;
}

double root_of_channels(const std::vector<ChannelNoise>& noise) {
  return std::sqrt(std::max(1.0, static_cast<double>(noise.size())));
}

PredictionLadder thinned(const PredictionLadder& ladder, std::size_t samples) {
  PredictionLadder few = ladder;
  few.stretches.clear();
  samples = static_cast<std::size_t>(std::ceil(static_cast<double>(samples) / root_of_channels(ladder.noise)));
  for (std::size_t h = 0; h < ladder.lengths.size(); ++h) {
    std::vector<const PredictedStretch*> own;
    std::size_t all = 0;
    for (const PredictedStretch& stretch : ladder.stretches)
      if (stretch.length == h) own.push_back(&stretch), all += static_cast<std::size_t>(stretch.stretch.size());
    if (own.empty()) continue;
    const std::size_t wanted = (samples * own.size() + all - 1) / all;
    const std::size_t count = std::min(own.size(), std::max(kFewestOfALength, wanted));
    for (std::size_t i = 0; i < count; ++i) few.stretches.push_back(*own[(2 * i + 1) * own.size() / (2 * count)]);
  }
  return few;
}

}  // namespace lacuna
