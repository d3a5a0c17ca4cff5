#include "answer/settling_test.h"

#include "answer/evidence.h"
#include "answer/fitted_values.h"
#include "experiment_design/propose_test.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSurelyBehind = 3.0;  ///< standard errors

/// The cheapest of the sets that are indistinguishable from the answer; where there are none, the nearest set with
/// another meaning unless the answer's lead is sure. Null: there is none.
const FittedModel* candidate_of(const SearchResult& found) {
  const FittedModel* least = nullptr;
  for (const std::size_t i : found.decision.alike)
    if (!least || found.sets[i].judged.cost.cost < least->judged.cost.cost) least = &found.sets[i];
  if (least) return least;
  const OtherSet other = nearest_other(found);
  return other.set && !other.set->model.added.empty() && other.lead < kSurelyBehind ? other.set : nullptr;
}

/// A test begins as the first recording does. The answer's residual of the shortest predictions is noise of single
/// readings; the additional residual of the longest ones is correlated over about the shortest length.
TestConditions conditions(const SearchResult& found, const std::vector<HorizonError>& errors, double period) {
  TestConditions conditions;
  const std::vector<Trial>& trials = found.data->task().trials;
  const auto fitted = std::find_if(trials.begin(), trials.end(), [](const Trial& trial) { return !trial.held_out; });
  const StartEstimate start = found.data->starts().at(static_cast<std::size_t>(fitted - trials.begin()), 0);
  conditions.start = start.start;
  for (const double deviation : start.deviation)
    conditions.start_deviation.push_back(std::isfinite(deviation) ? deviation : 0.0);
  conditions.noise = found.data->ladder().noise;
  const double alike = std::max(1.0, 2.0 * found.data->ladder().lengths.front() / period);
  for (ChannelNoise& noise : conditions.noise) {
    double single = 0.0, longest = 0.0;
    for (const HorizonError& error : errors) {  // the shortest first
      if (error.channel != noise.channel || !std::isfinite(error.answer)) continue;
      longest = error.answer * error.answer;
      if (single == 0.0) single = std::max(longest, noise.deviation * noise.deviation);
    }
    if (single > 0.0) noise.deviation = std::sqrt(single + alike * std::max(0.0, longest - single));
  }
  return conditions;
}

FittedCandidate candidate(const FittedModel& set, const FittedValues& values) {
  return {fmt::format("{}", fmt::join(set.judged.members, " + ")), set.model.definition, values.values(),
          values.timing(), values.covariance()};
}

/// Whether a test is worth a trip to the rig and worth more than a random test.
bool is_worthwhile(const NextTest& test) {
  constexpr double kWorthwhile = 1.0;  // nats per trial: a smaller worth does not justify a trip to the rig
  constexpr double kMostTrips = 20.0;
  return test.nats > test.random_nats && test.nats > kWorthwhile && test.trials <= kMostTrips;
}

void state(const NextTest& test, Diagnosis& diagnosis) {
  if (!is_worthwhile(test)) {
    diagnosis.findings.push_back(
        fmt::format("no test within the limits of the actuators separates {} from {}; widen the limits or add a sensor",
                    test.candidates[0], test.candidates[1]));
    return;
  }
  diagnosis.next_test = test.line;
  diagnosis.next_test_setup = test.setup;
  diagnosis.next_test_worth = to_string(test);
}

}  // namespace

void propose_settling_test(const DiagnosisTask& task, const SearchResult& found, Diagnosis& result) {
  const FittedModel* other = candidate_of(found);
  if (found.decision.answer == 0 || !other) return;
  const FittedModel& answer = found.answer();
  const FittedValues of_answer(found, answer), of_other(found, *other);
  const std::optional<NextTest> test = propose_test(
      task.catalog, task.experiment, candidate(answer, of_answer), candidate(*other, of_other), task.trials,
      [&](double period) { return conditions(found, result.horizons, period); }, task.seed, task.work.unreported());
  if (test) state(*test, result);
}

}  // namespace lacuna
