#include "eea/ensemble/judges.h"

#include "eea/ensemble/ensemble.h"
#include "eea/ensemble/ensemble_prediction.h"
#include "eea/trials/scored_trials.h"
#include "evaluation/model/channel_map.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMove = 1e-3;       // of a free value's range, the step of a slope
constexpr double kFlatPrior = 12.0;  // the inverse of the variance of a value anywhere within 0 ... 1

/// Step of a value for its slope, in ranges: towards the middle, where there is always room, and a whole step for
/// integers. 0: the value cannot move.
double move_of(const FreeValue& value, double at, const EngineSettings& engine) {
  const double range = value.upper - value.lower;
  if (!std::isfinite(range) || range <= 0.0 || std::isnan(at)) return 0.0;  // unknown: the value of an absent effect
  const double move = counts_in_steps(value, engine) ? std::max(kMove, engine.step / range) : kMove;
  if (move > 0.5) return 0.0;
  return at < value.lower + 0.5 * range ? move : -move;
}

std::vector<double> moves_of(const ModelProposal& model, const ModelDefinition& definition) {
  std::vector<double> moves;
  for (std::size_t k = 0; k < definition.free.size(); ++k)
    moves.push_back(move_of(definition.free[k], model.values[k], definition.engine));
  return moves;
}

/// Information of a trial on the values: products of the deviations that each value's whole range would cause in the
/// measured readings. `map`: channel of the prediction for each of the trial's.
Eigen::MatrixXd information_in(const TestPrediction& prediction, const Trial& trial,
                               const std::vector<Eigen::Index>& map, const std::vector<double>& noise) {
  const auto values = static_cast<Eigen::Index>(prediction.slopes.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(values, values);
  for (std::size_t c = 0; c < map.size(); ++c) {
    const auto measured = trial.measured.samples.col(static_cast<Eigen::Index>(c)).array();
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(measured.size(), values);
    for (Eigen::Index k = 0; k < values; ++k) {
      const TimeSeries::Samples& slope = prediction.slopes[static_cast<std::size_t>(k)];
      if (slope.size() > 0)
        slopes.col(k) =
            measured.isFinite().select(slope.col(map[c]).array() / noise[static_cast<std::size_t>(map[c])], 0.0);
    }
    information += slopes.transpose() * slopes;
  }
  return information;
}

}  // namespace

Judges::Judges(const EeaDefinition& definition, const Work& work, const EeaState& state)
    : definition_(definition),
      stop_(work.stop),
      predictor_(*definition_.compiled, definition_.sample_times, work, &definition_.model,
                 definition_.value.models()) {
  for (const std::size_t i : differing(state.best, definition_.value.models(), definition_.phenotypes))
    judges_.push_back({state.best[i].model});
  const std::vector<ScoredTrial> trials = scored_trials(definition_, state);
  if (!judges_.empty()) noise_ = noise_of_readings(definition_, judges_.front().model, trials, steps_, stop_);
  std::replace(noise_.begin(), noise_.end(), 0.0, kInfinity);  // a channel that never moved gives no information
  if (!definition_.value.wants_slopes()) return;
  for (Judge& judge : judges_) find_information(trials, judge);
}

void Judges::find_information(const std::vector<ScoredTrial>& trials, Judge& judge) {
  judge.moves = moves_of(judge.model, definition_.model);
  const auto values = static_cast<Eigen::Index>(judge.moves.size());
  judge.information = kFlatPrior * Eigen::MatrixXd::Identity(values, values);
  std::string reason;
  for (const ScoredTrial& scored : trials) {
    const TestPredictor predictor(*definition_.compiled, sampled_at(scored), {1, stop_}, &definition_.model, 1,
                                  scored.trial.measured.times(0));
    const Test test = as_carried_out(scored);
    TestPrediction prediction;
    if (predictor.predict(judge.model, test, 0, prediction, steps_, reason) &&
        add_slopes(predictor, judge, test, 0, prediction, steps_, reason))
      judge.information += information_in(prediction, scored.trial,
                                          match_channels(scored.trial, definition_.compiled->channels()), noise_);
  }
}

bool Judges::add_slopes(const TestPredictor& predictor, const Judge& judge, const Test& test, int worker,
                        TestPrediction& prediction, std::uint64_t& steps, std::string& reason) const {
  prediction.slopes.resize(judge.moves.size());
  ModelProposal moved = judge.model;
  TestPrediction there;
  for (std::size_t k = 0; k < judge.moves.size(); ++k) {
    if (judge.moves[k] == 0.0) continue;
    const FreeValue& value = definition_.model.free[k];
    moved.values[k] = judge.model.values[k] + judge.moves[k] * (value.upper - value.lower);
    if (!predictor.predict(moved, test, worker, there, steps, reason)) return false;
    moved.values[k] = judge.model.values[k];
    prediction.slopes[k] = (there.sensors.samples - prediction.sensors.samples) / judge.moves[k];
  }
  return true;
}

bool Judges::predict(const Test& test, int worker, std::span<TestPrediction> predictions, std::uint64_t& steps,
                     std::string& reason) const {
  for (std::size_t i = 0; i < judges_.size(); ++i) {
    const Judge& judge = judges_[i];
    TestPrediction& prediction = predictions[i];
    if (!predictor_.predict(judge.model, test, worker, prediction, steps, reason)) return false;
    prediction.noise = noise_;
    if (judge.moves.empty()) continue;
    if (!add_slopes(predictor_, judge, test, worker, prediction, steps, reason)) return false;
    prediction.information = judge.information;
  }
  return true;
}

}  // namespace lacuna
