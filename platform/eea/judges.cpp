#include "eea/judges.h"

#include "eea/ensemble.h"
#include "eea/ensemble_prediction.h"
#include "eea/scored_trials.h"

#include <cmath>

namespace lacuna {
namespace {

constexpr double kMove = 1e-3;       // of a free value's range, for a slope
constexpr double kFlatPrior = 12.0;  // the inverse of the variance of what lies anywhere within 0 ... 1

std::vector<double> times_of(const ScoredTrial& scored) {
  const Eigen::VectorXd& times = scored.trial.measured.times;
  return {times.data(), times.data() + times.size()};
}

/// Towards the middle of its range a value can always move.
std::vector<double> moves_of(const ModelProposal& model, const std::vector<FreeValue>& free) {
  std::vector<double> moves;
  for (std::size_t k = 0; k < free.size(); ++k) {
    const double range = free[k].upper - free[k].lower;
    const bool can_move = std::isfinite(range) && range > 0.0 && !std::isnan(model.values[k]);  // of an absent effect
    const bool below_middle = model.values[k] < free[k].lower + 0.5 * range;
    moves.push_back(!can_move ? 0.0 : below_middle ? kMove : -kMove);
  }
  return moves;
}

/// Squared deviations that a value's whole range would make, of the channels that the trial measured.
Eigen::MatrixXd information_in(const TestPrediction& prediction, const std::vector<double>& noise) {
  const auto values = static_cast<Eigen::Index>(prediction.slopes.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(values, values);
  for (std::size_t c = 0; c < noise.size(); ++c) {
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(prediction.sensors.samples.rows(), values);
    for (Eigen::Index k = 0; k < values; ++k) {
      const TimeSeries::Samples& slope = prediction.slopes[static_cast<std::size_t>(k)];
      if (slope.size() > 0) slopes.col(k) = slope.col(static_cast<Eigen::Index>(c)) / noise[c];
    }
    information += slopes.transpose() * slopes;
  }
  return information;
}

}  // namespace

Judges::Judges(const EeaRun& run, const EeaState& state)
    : definition_(run.definition),
      predictor_(*definition_.compiled, definition_.sample_times, run.threads, &definition_.model,
                 definition_.value.models()) {
  for (const std::size_t i : differing(state.best, definition_.value.models()))
    judges_.push_back({state.best[i].model});
  const std::vector<ScoredTrial> trials = scored_trials(definition_, state);
  if (!judges_.empty()) noise_ = noise_of_readings(definition_, judges_.front().model, trials);
  if (!definition_.value.wants_slopes()) return;
  for (Judge& judge : judges_) find_information(trials, judge);
}

void Judges::find_information(const std::vector<ScoredTrial>& trials, Judge& judge) const {
  judge.moves = moves_of(judge.model, definition_.model.free);
  const auto values = static_cast<Eigen::Index>(judge.moves.size());
  judge.information = kFlatPrior * Eigen::MatrixXd::Identity(values, values);
  std::uint64_t steps = 0;
  std::string reason;
  for (const ScoredTrial& scored : trials) {
    const TestPredictor predictor(*definition_.compiled, times_of(scored), 1, &definition_.model);
    TestPrediction prediction;
    if (predictor.predict(judge.model, scored.test, 0, prediction, steps, reason) &&
        add_slopes(predictor, judge, scored.test, 0, prediction, steps, reason))
      judge.information += information_in(prediction, noise_);
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
