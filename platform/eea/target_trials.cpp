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

/// A test and what the target did.
struct CarriedOut {
  Test drive;
  Trial trial;
  double fitness = kNotKnown;
};

CarriedOut carry_out(const EeaRun& run, const EeaTarget& target, const Genome& test, int number) {
  CarriedOut done{run.definition.decode_test(test), {}};
  done.trial = trial_of(target, done.drive, number);
  done.fitness = measured_fitness(run.definition, done.drive, done.trial);
  return done;
}

/// Puts random tests in the place of tests that fail, a few times. Input that is wrong stays so, and a user who ends
/// the run is obeyed.
CarriedOut carry_out_or_replace(const EeaRun& run, const EeaTarget& target, EeaState& state, int number) {
  for (int attempt = 1;; ++attempt) try {
      return carry_out(run, target, state.next_test->genome, number);
    } catch (const BadInput&) {
      throw;
    } catch (const Interrupted&) {
      throw;
    } catch (const Error& error) {
      if (attempt == kAttempts)
        throw Error("trial " + std::to_string(number) + ": " + error.what() + " (after " + std::to_string(kAttempts) +
                    " tests)");
      choose_random_test(run, state, attempt);
    }
}

}  // namespace

void carry_out_test(const EeaRun& run, const EeaTarget& target, EeaState& state, bool for_transfer) {
  const auto number = static_cast<int>(state.trials.size());
  CarriedOut done = carry_out_or_replace(run, target, state, number);
  const NextTest& test = *state.next_test;
  run.journal.add(TargetTrialRow{number, test.number, {}, for_transfer, test.predicted_fitness, done.fitness},
                  done.trial);
  if (!state.best.empty()) note_prediction(run, state, number, done.drive);
  state.trials.push_back({test.number, std::move(done.drive), std::move(done.trial)});
  state.next_test.reset();
}

void note_prediction(const EeaRun& run, const EeaState& state, int trial, const Test& drive) {
  const TestPredictor predictor(*run.definition.compiled, run.definition.sample_times, 1, &run.definition.model);
  TestPrediction prediction;
  std::uint64_t steps = 0;
  std::string reason;
  if (predictor.predict(state.best.front().model, drive, 0, prediction, steps, reason))
    run.journal.add_prediction(state.best.front().number, trial, prediction.sensors, prediction.centre_of_mass);
}

}  // namespace lacuna
