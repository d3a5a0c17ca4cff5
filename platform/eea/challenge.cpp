#include "eea/challenge.h"

#include "eea/definition/evaluations.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kLongestWait = 3;          // passes
constexpr std::size_t kFirstTrials = 2;  // trials from which everything starts
constexpr double kSmallError = 0.01;     // of the error of a model that never moves: a smaller error is not a challenge

/// Of the best model.
double score_on(const EeaRun& run, EeaState& state, const TargetTrial& trial, int pass) {
  const ModelScore score = run.evaluations->score_on(state.best.front(), trial, pass);
  state.counts.test_steps += score.steps;
  return score.kind == ScoreKind::full ? score.total : kNotKnown;
}

/// The error of readings against their mean.
double score_of_standing_still(const EeaRun& run, const ScoredTrial& scored) {
  const TimeSeries::Samples& measured = scored.trial.measured.samples;
  std::vector<double> means;
  for (Eigen::Index c = 0; c < measured.cols(); ++c) {
    const auto known = measured.col(c).array().isFinite();
    const double count = std::max(1.0, static_cast<double>(known.count()));
    means.push_back(known.select(measured.col(c).array(), 0.0).sum() / count);
  }
  const Chosen<FitnessMetric>& metric = run.definition.metric;
  return guarded_call(metric.origin, "accumulator", [&] {
    const auto tally = metric->accumulator(
        {1, static_cast<std::size_t>(measured.rows()), static_cast<std::size_t>(measured.cols())}, metric.parameters);
    for (Eigen::Index row = 0; row < measured.rows(); ++row)
      tally->add(means, {measured.data() + row * measured.cols(), means.size()});
    return tally->score();
  });
}

bool too_hard(const EeaRun& run, const EeaState& state, const ScoredTrial& scored, double score) {
  if (std::isnan(score)) return true;
  const double usual = std::max(state.best.front().score, kSmallError * score_of_standing_still(run, scored));
  return score > run.definition.challenge * usual;
}

/// Before a pass's estimation, its models are those of the previous pass.
int pass_of_best(const EeaState& state) { return state.pass - 1; }

bool is_managed(const EeaRun& run, const EeaState& state) {
  return run.definition.challenge > 0.0 && !state.best.empty() && std::isfinite(state.best.front().score);
}

}  // namespace

double surprise_of(const EeaRun& run, EeaState& state, const TargetTrial& trial) {
  if (state.best.empty()) return kNotKnown;
  return score_on(run, state, trial, pass_of_best(state));
}

void set_aside_if_too_hard(const EeaRun& run, EeaState& state, double surprise) {
  if (!is_managed(run, state) || state.trials.size() <= kFirstTrials) return;
  TargetTrial& newest = state.trials.back();
  if (too_hard(run, state, run.definition.scored(newest.drive, newest.trial, pass_of_best(state)), surprise))
    newest.set_aside_in = state.pass;
}

void recall_trials(const EeaRun& run, EeaState& state) {
  if (!is_managed(run, state)) return;
  for (TargetTrial& trial : state.trials) {
    if (!trial.set_aside_in) continue;
    const ScoredTrial scored = run.definition.scored(trial.drive, trial.trial, state.pass);
    const bool waited = state.pass - *trial.set_aside_in + 1 >= kLongestWait;
    if (waited || !too_hard(run, state, scored, score_on(run, state, trial, state.pass))) trial.set_aside_in.reset();
  }
}

}  // namespace lacuna
