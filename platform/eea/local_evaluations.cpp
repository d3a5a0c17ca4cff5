#include "eea/local_evaluations.h"

#include "eea/ensemble/judges.h"
#include "eea/trials/scored_trials.h"
#include "evaluation/prediction/test_predictor.h"
#include "foundation/processes/stop.h"
#include "foundation/parallel.h"
#include "foundation/plugins/plugin_call.h"

#include <cmath>
#include <utility>

namespace lacuna {

/// The judges and each thread's memory for their predictions.
struct LocalEvaluations::Panel {
  Panel(const EeaDefinition& of, const Work& work, const EeaState& state)
      : definition(of),
        judges(of, work, state),
        predictions(static_cast<std::size_t>(judges.workers()), std::vector<TestPrediction>(judges.size())) {}

  void judge(const Genome& genome, int worker, JudgedTest& judged) {
    const Evaluation evaluation;
    try {
      find_fitness(definition.decode_test(genome), worker, judged);
    } catch (const Interrupted&) {
      throw;
    } catch (const Error& error) {
      judged.reason = error.what();
    }
  }

  void find_fitness(const Test& test, int worker, JudgedTest& judged) {
    std::vector<TestPrediction>& predicted = predictions[static_cast<std::size_t>(worker)];
    if (!judges.predict(test, worker, predicted, judged.steps, judged.reason)) return;
    judged.fitness = definition.value.score(test, predicted);
    if (std::isfinite(judged.fitness)) return;
    judged.reason = definition.value.why_not_finite(test, predicted);
    if (judged.reason.empty()) judged.reason = "the weighted sum of the test's fitnesses is not finite";
  }

  const EeaDefinition& definition;
  Judges judges;
  std::vector<std::vector<TestPrediction>> predictions;  // by worker
};

LocalEvaluations::LocalEvaluations(const EeaDefinition& definition, const Work& work)
    : definition_(definition), work_(work) {}
LocalEvaluations::~LocalEvaluations() = default;

void LocalEvaluations::begin_estimation(const EeaState& state) {
  panel_.reset();
  scorer_ = std::make_unique<ModelScorer>(*definition_.compiled, scored_trials(definition_, state), definition_.metric,
                                          work_, &definition_.model, definition_.profiled);
}

std::vector<ModelScore> LocalEvaluations::score(std::span<const CandidateModel> candidates, std::optional<double> bar) {
  std::vector<ModelScore> scores(candidates.size());
  parallel_for(candidates.size(), scorer_->workers(), [&](std::size_t i, int worker) {
    const Evaluation evaluation;
    scorer_->score(*candidates[i].model, bar, worker, scores[i]);
  });
  return scores;
}

std::uint64_t LocalEvaluations::begin_exploration(const EeaState& state) {
  scorer_.reset();
  panel_ = std::make_unique<Panel>(definition_, work_, state);
  return panel_->judges.steps();
}

std::vector<JudgedTest> LocalEvaluations::judge(std::span<const Genome> tests) {
  std::vector<JudgedTest> judged(tests.size());
  parallel_for(tests.size(), panel_->judges.workers(),
               [&](std::size_t i, int worker) { panel_->judge(tests[i], worker, judged[i]); });
  return judged;
}

ModelScore LocalEvaluations::score_on(const KnownModel& model, const TargetTrial& trial, int pass) {
  const Evaluation evaluation;
  const ModelScorer scorer(*definition_.compiled, {definition_.scored(trial.drive, trial.trial, pass)},
                           definition_.metric, {1, work_.stop}, &definition_.model);
  ModelScore score;
  scorer.score(model.model, std::nullopt, 0, score);
  return score;
}

PredictedTrial LocalEvaluations::predict_trial(const KnownModel& model, const TargetTrial& trial) {
  const TestPredictor predictor(*definition_.compiled, definition_.sample_times, {1, work_.stop}, &definition_.model);
  PredictedTrial predicted;
  std::string reason;
  predicted.valid = predictor.predict(model.model, trial.drive, 0, predicted.prediction, predicted.steps, reason);
  return predicted;
}

std::vector<ModelScore> LocalEvaluations::find_delays(std::span<const KnownModel* const> models,
                                                      const EeaState& state) {
  std::vector<ScoredTrial> trials;
  for (const TargetTrial& trial : state.trials)
    if (!trial.set_aside_in) trials.push_back(definition_.observed(trial.drive, trial.trial));
  const ModelScorer scorer(*definition_.compiled, std::move(trials), definition_.metric, {1, work_.stop},
                           &definition_.model, definition_.profiled);
  std::vector<ModelScore> scores(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Evaluation evaluation;
    scorer.score(models[i]->model, std::nullopt, 0, scores[i]);
  }
  return scores;
}

}  // namespace lacuna
