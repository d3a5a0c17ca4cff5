#include "eea/target_trials.h"

#include "eea/exploration.h"
#include "evaluation/test_predictor.h"

#include <array>

namespace lacuna {
namespace {

constexpr int kAttempts = 5;

Trial trial_of(const EeaTarget& target, const Test& drive, int number) {
  if (target.simulator) target.simulator->begin_trial(static_cast<std::uint64_t>(number));
  Trial trial = guarded_call(target.origin, "carrying a test out", [&] {
    return target.system.carry_out(drive, {.trials = nullptr, .simulator = target.simulator});
  });
  trial.name = std::to_string(number);
  return trial;
}

/// The test's fitness as the target showed it; not known where it takes several models.
double measured_fitness(const EeaDefinition& definition, const Test& drive, const Trial& trial) {
  if (definition.models_for_tests != 1 || trial.centre_of_mass.times.size() == 0) return kNotKnown;
  const std::array<TestPrediction, 1> seen = {TestPrediction{trial.measured, trial.centre_of_mass}};
  const Chosen<TestFitness>& fitness = definition.fitness;
  return guarded_call(fitness.origin, "score", [&] { return fitness->score(drive, seen, fitness.parameters); });
}

}  // namespace

void carry_out_test(const EeaRun& run, const EeaTarget& target, EeaState& state, bool for_transfer) {
  const auto number = static_cast<int>(state.trials.size());
  for (int attempt = 1;; ++attempt) {
    const NextTest& test = *state.next_test;
    const Test drive = run.definition.decode_test(test.genome);
    try {
      Trial trial = trial_of(target, drive, number);
      run.journal.add(TargetTrialRow{number,
                                     test.number,
                                     {},
                                     for_transfer,
                                     test.predicted_fitness,
                                     measured_fitness(run.definition, drive, trial)},
                      trial);
      state.trials.push_back({test.number, drive, std::move(trial)});
      if (!state.best.empty()) note_prediction(run, state, number, drive);
      state.next_test.reset();
      return;
    } catch (const Error& error) {
      if (attempt == kAttempts)
        throw Error("trial " + std::to_string(number) + ": " + error.what() + " (after " + std::to_string(kAttempts) +
                    " tests)");
      choose_random_test(run, state, attempt);
    }
  }
}

void note_prediction(const EeaRun& run, const EeaState& state, int trial, const Test& drive) {
  const TestPredictor predictor(*run.definition.compiled, run.definition.sample_times, 1);
  TestPrediction prediction;
  std::uint64_t steps = 0;
  std::string reason;
  if (predictor.predict(state.best.front().values, drive, 0, prediction, steps, reason))
    run.journal.add_prediction(state.best.front().number, trial, prediction.sensors, prediction.centre_of_mass);
}

}  // namespace lacuna
