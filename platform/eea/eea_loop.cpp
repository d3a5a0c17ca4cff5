#include "eea/eea_loop.h"

#include "eea/estimation.h"
#include "eea/exploration.h"

#include <utility>

namespace lacuna {
namespace {

/// The best model of the pass, and how far it is from the truth.
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

/// Writes the pass down and begins the next one.
void end_pass(const EeaRun& run, EeaState& state) {
  sum_up(run, state, state.counts);
  run.journal.add(std::exchange(state.counts, {}));
  ++state.pass;
}

void go_on_with(Phase phase, const EeaRun& run, EeaState& state) {
  state.phase = phase;
  run.end_generation(state, {.pass = state.pass, .passes = run.definition.passes, .phase = phase});
}

/// A trial of a target outside may have taken minutes of a rig: it is made safe at once.
void go_on_after_trial(Phase phase, const EeaRun& run, const EeaTarget& target, EeaState& state) {
  go_on_with(phase, run, state);
  if (target.program) run.journal.checkpoint(state, true);
}

/// A state that was stored has genomes and values only.
void decode_again(const EeaDefinition& definition, std::vector<KnownModel>& models) {
  for (KnownModel& known : models)
    if (!known.genome.empty()) known.model = definition.decode_model(known.genome);
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

void eea_loop(const EeaRun& run, const EeaTarget& target, EeaState& state) {
  decode_again(run.definition, state.best);
  while (state.phase != Phase::finished) switch (state.phase) {
      case Phase::trial:  // steps 1 and 2: a test, the first one random, is sent to the target
        if (!state.next_test) choose_random_test(run, state, 0);
        carry_out_test(run, target, state, false);
        go_on_after_trial(Phase::estimation, run, target, state);
        break;
      case Phase::estimation:  // step 3: models that explain all trials so far
        estimate(run, state);
        if (target.system.takes_tests())
          note_prediction(run, state, static_cast<int>(state.trials.size()) - 1, state.trials.back().drive);
        else
          end_pass(run, state);
        go_on_with(target.system.takes_tests() ? Phase::exploration : Phase::finished, run, state);
        break;
      case Phase::exploration:  // step 4: the test that the models choose
        explore(run, state);
        end_pass(run, state);
        go_on_with(state.pass <= run.definition.passes ? Phase::trial : Phase::transfer, run, state);
        break;
      case Phase::transfer:  // how the last test does on the target
        carry_out_test(run, target, state, true);
        go_on_after_trial(Phase::finished, run, target, state);
        break;
      case Phase::finished: break;
    }
}

}  // namespace lacuna
