#include "eea/eea_loop.h"

#include "eea/challenge.h"
#include "eea/ensemble/ensemble.h"
#include "eea/estimation.h"
#include "eea/exploration.h"
#include "eea/local_evaluations.h"
#include "eea/stopping.h"

#include <utility>

namespace lacuna {
namespace {

/// The best model of the pass, and its distance from the truth.
void sum_up(const EeaRun& run, const EeaState& state, PassRow& pass) {
  pass.number = state.pass;
  const KnownModel& best = state.best.front();
  if (best.genome.empty()) return;  // the approximate model that came with the experiment
  pass.best_model = best.number;
  pass.best_score = best.score;
  pass.best_values = best.model.values;
  if (!run.definition.objective || !run.target) return;
  const Chosen<ObjectiveMetric>& metric = *run.definition.objective;
  const std::vector<ObjectiveScore> scores = guarded_call(metric.origin, "score", [&] {
    return metric->score(run.definition.model_space, best.model, {run.truth, *run.target}, metric.parameters);
  });
  for (const ObjectiveScore& score : scores) pass.objective.push_back({score.name, score.unit, score.value});
}

/// The different models that the pass hands on.
void note_ensemble(const EeaDefinition& definition, const EeaState& state, PassRow& pass) {
  for (const std::size_t i : differing(state.best, definition.ensemble, definition.phenotypes)) {
    const KnownModel& known = state.best[i];
    if (known.genome.empty()) continue;  // the approximate model
    pass.ensemble.push_back({known.number, known.score, known.model.structure, known.model.values});
  }
}

/// Trials that the pass set aside.
void note_set_aside(const EeaState& state, PassRow& pass) {
  for (std::size_t t = 0; t < state.trials.size(); ++t)
    if (state.trials[t].set_aside_in) pass.set_aside.push_back(static_cast<int>(t));
}

/// Step 4, unless another test is of no use, which the pass then records. The last pass, and the first test of an
/// approximate model, always make their test.
void explore_or_stop(const EeaRun& run, EeaState& state) {
  const bool may_stop = state.pass > 0 && state.pass < run.definition.passes;
  if (may_stop) state.counts.stopped = lost_patience(run, state);
  if (!state.counts.stopped.empty()) return;
  explore(run, state);
  if (may_stop) state.counts.stopped = too_little_to_learn(run, state);
}

/// Records the pass and prepares the next.
Phase end_pass(const EeaRun& run, EeaState& state) {
  sum_up(run, state, state.counts);
  note_ensemble(run.definition, state, state.counts);
  note_set_aside(state, state.counts);
  const bool stop = !state.counts.stopped.empty();
  recall_trials(run, state);
  run.journal.add(std::exchange(state.counts, {}));
  ++state.pass;
  return stop ? Phase::finished : state.pass <= run.definition.passes ? Phase::trial : Phase::transfer;
}

void go_on_with(Phase phase, const EeaRun& run, EeaState& state) {
  state.phase = phase;
  run.end_generation(state, {.pass = state.pass, .passes = run.definition.passes, .phase = phase});
}

/// A trial of an outside target may have taken minutes of rig time, so it is stored at once.
void go_on_after_trial(Phase phase, const EeaRun& run, const EeaTarget& target, EeaState& state) {
  go_on_with(phase, run, state);
  if (target.program) run.journal.checkpoint(state, true);
}

/// A stored state has genomes and values only.
void decode_again(const EeaDefinition& definition, std::vector<KnownModel>& models) {
  for (KnownModel& known : models)
    if (!known.genome.empty()) {
      std::vector<double> values = std::move(known.model.values);  // with delays that are not genes
      known.model = definition.decode_model(known.genome);
      known.model.values = std::move(values);
    }
}

}  // namespace

EeaState first_state(const EeaDefinition& definition) {
  EeaState state;
  if (!definition.approximate) return state;
  state.pass = 0;
  state.phase = Phase::exploration;
  state.best.push_back({0, {}, {definition.model.start_values()}, kNotKnown});
  return state;
}

namespace {

void go_through(const EeaRun& run, const EeaTarget& target, EeaState& state) {
  decode_again(run.definition, state.best);
  decode_again(run.definition, state.found);
  while (state.phase != Phase::finished) switch (state.phase) {
      case Phase::trial:  // steps 1 and 2: a test, the first one random, is sent to the target
        if (!state.next_test) choose_random_test(run, state, 0);
        carry_out_test(run, target, state, false);
        go_on_after_trial(Phase::estimation, run, target, state);
        break;
      case Phase::estimation:  // step 3: models that explain all trials so far
        estimate(run, state);
        if (target.system.takes_tests())
          note_prediction(run, state, static_cast<int>(state.trials.size()) - 1, state.trials.back());
        else
          end_pass(run, state);
        go_on_with(target.system.takes_tests() ? Phase::exploration : Phase::finished, run, state);
        break;
      case Phase::exploration:  // step 4: the test that the models choose
        explore_or_stop(run, state);
        go_on_with(end_pass(run, state), run, state);
        break;
      case Phase::transfer:  // how the last test does on the target
        carry_out_test(run, target, state, true);
        go_on_after_trial(Phase::finished, run, target, state);
        break;
      case Phase::finished: break;
    }
}

}  // namespace

void eea_loop(const EeaRun& run, const EeaTarget& target, EeaState& state) {
  LocalEvaluations here(run.definition, run.work);
  EeaRun evaluated = run;
  if (!evaluated.evaluations) evaluated.evaluations = &here;
  go_through(evaluated, target, state);
}

}  // namespace lacuna
