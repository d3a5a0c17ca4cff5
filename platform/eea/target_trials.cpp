#include "eea/target_trials.h"

#include "eea/challenge.h"
#include "eea/definition/evaluations.h"
#include "eea/exploration.h"
#include "eea/trials/recorded_trials.h"
#include "eea/stopping.h"
#include "foundation/processes/stop.h"
#include "process/hello.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace lacuna {
namespace {

constexpr int kTests = 5;

/// A value that no sensor can read is not a measurement, and would outweigh all others.
void check_readings(const TimeSeries& measured, const ComponentOrigin& target) {
  for (std::size_t c = 0; c < measured.channels.size(); ++c) {
    const auto readings = measured.samples.col(static_cast<Eigen::Index>(c)).array();
    if ((readings.isNaN() || readings.abs() <= kLargestReading).all()) continue;
    throw Error(
        fmt::format("{}: it reads more than {:g} {} of \"{}\", which no sensor can; check the unit of this channel in "
                    "the target's program",
                    to_string(target), kLargestReading, measured.channels[c].unit, measured.channels[c].name));
  }
}

Trial trial_of(const EeaTarget& target, const Test& drive, int number) {
  if (target.simulator) target.simulator->begin_trial(static_cast<std::uint64_t>(number));
  if (target.program) target.program->begin_trial(static_cast<std::uint64_t>(number));
  const CallAllowance lasts(drive.duration);
  Trial trial = guarded_call(target.origin, "carrying a test out", [&] {
    return target.system.carry_out(drive, {.simulator = target.simulator, .program = target.program});
  });
  check_readings(trial.measured, target.origin);
  trial.name = std::to_string(number);
  return trial;
}

/// The test's fitness from the target's response; not known where it needs several models or their slopes.
double measured_fitness(const EeaDefinition& definition, const Test& drive, const Trial& trial) {
  if (definition.value.models() != 1 || definition.value.wants_slopes() || trial.centre_of_mass.times.size() == 0)
    return kNotKnown;
  const std::array<TestPrediction, 1> seen = {TestPrediction{trial.measured, trial.centre_of_mass}};
  return definition.value.score(drive, seen);
}

/// A test and the target's response.
struct CarriedOut {
  Test drive;
  Trial trial;
  double fitness = kNotKnown;
};

CarriedOut carry_out(const EeaRun& run, const EeaTarget& target, const Genome& test, int number) {
  CarriedOut done{run.definition.decode_test(test), {}};
  done.trial = trial_of(target, done.drive, number);
  done.drive = run.definition.drive_of(std::move(done.drive), done.trial);
  done.fitness = measured_fitness(run.definition, done.drive, done.trial);
  return done;
}

/// Carries out the next test; returns nothing, after recording the failure, where the target fails. Invalid input is
/// not tried again; an interruption by the user is obeyed.
std::optional<CarriedOut> attempt(const EeaRun& run, const EeaTarget& target, const PendingTest& test, int number,
                                  std::string& reason) {
  try {
    return carry_out(run, target, test.genome, number);
  } catch (const BadInput&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& error) {
    reason = error.what();
    run.journal.note_failure({std::to_string(number), std::to_string(test.number), reason});
    return std::nullopt;
  }
}

void replace_by_random(const EeaRun& run, EeaState& state, int number, int attempt) {
  const std::uint64_t given_up = state.next_test->number;
  choose_random_test(run, state, attempt);
  run.journal.note(fmt::format("trial {}: test {} is given up; random test {} takes its place", number, given_up,
                               state.next_test->number));
}

/// Repeats tests that fail, and replaces them by random ones, a few times.
CarriedOut carry_out_or_replace(const EeaRun& run, const EeaTarget& target, EeaState& state, int number) {
  std::string reason;
  for (int test = 1; test <= kTests; ++test) {
    if (test > 1) replace_by_random(run, state, number, test - 1);
    for (int repeat = 0; repeat <= target.repeats; ++repeat) {
      if (test + repeat > 1) run.work.stop.pause_for(target.pause);
      if (std::optional<CarriedOut> done = attempt(run, target, *state.next_test, number, reason))
        return std::move(*done);
    }
  }
  throw Error(fmt::format("trial {} failed with {} tests{}; the last error: {}", number, kTests,
                          target.repeats > 0 ? fmt::format(", each tried {} times", target.repeats + 1) : "", reason));
}

}  // namespace

void carry_out_test(const EeaRun& run, const EeaTarget& target, EeaState& state, bool for_transfer) {
  const auto number = static_cast<int>(state.trials.size());
  CarriedOut done = carry_out_or_replace(run, target, state, number);
  const PendingTest& test = *state.next_test;
  TargetTrial trial{test.number, done.drive, with_known_start(run.definition, done.trial), test.genome};
  const double surprise = surprise_of(run, state, trial);
  run.journal.add(TargetTrialRow{number, test.number, {}, for_transfer, test.predicted_fitness, done.fitness, surprise},
                  done.trial);
  if (!state.best.empty()) note_prediction(run, state, number, trial);
  state.trials.push_back(std::move(trial));
  note_surprise(run, state, surprise);
  if (!for_transfer) set_aside_if_too_hard(run, state, surprise);
  state.next_test.reset();
}

void note_prediction(const EeaRun& run, EeaState& state, int number, const TargetTrial& trial) {
  const KnownModel& best = state.best.front();
  if (best.genome.empty()) return;  // the approximate model that came with the experiment: it has no row
  const PredictedTrial predicted = run.evaluations->predict_trial(best, trial);
  state.counts.test_steps += predicted.steps;
  if (predicted.valid)
    run.journal.add_prediction(best.number, number, predicted.prediction.sensors, predicted.prediction.centre_of_mass);
}

}  // namespace lacuna
