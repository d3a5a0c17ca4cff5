#include "app/runs/stored_model.h"

#include "app/runs/run_trials.h"
#include "eea/definition/delays.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Trials that did not count in a pass. Of a pass that has not ended nothing is known.
std::vector<int> set_aside_in(const EeaStore& store, int pass) {
  for (PassRow& row : store.passes())
    if (row.number == pass) return std::move(row.set_aside);
  return {};
}

/// What was stored of each trial that counted.
std::vector<double> without_gaps(std::vector<double> scores) {
  std::erase_if(scores, [](double score) { return std::isnan(score); });
  return scores;
}

}  // namespace

StoredModel stored_model(const EeaStore& store, const EeaDefinition& definition, std::uint64_t number,
                         const Stop& stop) {
  const std::optional<ModelRow> row = store.model(number);
  if (!row)
    throw_problem({}, fmt::format("--model {}: the run has no such model; models are numbered from 0, and lacuna runs "
                                  "lists how many there are",
                                  number));
  StoredModel model{definition, number, *row, definition.decode_model(row->genome), {}, {}, stop};
  std::vector<ScoredTrial> observed;
  const std::vector<int> set_aside = set_aside_in(store, row->pass);
  for (RunTrial& stored : run_trials(store, definition)) {
    const int trial = stored.row.number;
    if (stored.row.test && (stored.row.for_transfer || trial >= row->pass)) continue;
    if (std::find(set_aside.begin(), set_aside.end(), trial) != set_aside.end()) continue;
    model.trials.push_back(definition.scored(stored.drive, stored.trial, row->pass));
    observed.push_back(definition.observed(std::move(stored.drive), std::move(stored.trial)));
    model.numbers.push_back(trial);
  }
  if (!definition.profiled.empty()) Delays(definition, std::move(observed), stop).find(model.model);
  return model;
}

ModelScore score_again(const StoredModel& model) {
  const ModelScorer scorer(*model.definition.compiled, model.trials, model.definition.metric, {1, model.stop},
                           &model.definition.model, model.definition.profiled);
  ModelScore score;
  scorer.score(model.model, std::nullopt, 0, score);
  return score;
}

bool agrees(const ModelRow& stored, const ModelScore& score) {
  switch (stored.kind) {
    case ScoreKind::invalid: return score.kind == ScoreKind::invalid;
    case ScoreKind::abandoned: return score.kind == ScoreKind::full && score.total >= stored.score;
    case ScoreKind::full: break;
  }
  const std::vector<double> trials = without_gaps(score.trials), then = without_gaps(stored.trial_scores);
  return score.kind == ScoreKind::full && same(score.total, stored.score) &&
         std::equal(trials.begin(), trials.end(), then.begin(), then.end(), same);
}

}  // namespace lacuna
