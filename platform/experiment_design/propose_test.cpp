#include "experiment_design/propose_test.h"

#include "candidates/timing.h"
#include "evaluation/prediction/test_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace lacuna {
namespace {

constexpr double kLongest = 10.0;  ///< s
constexpr int kEvaluations = 24, kMoreForASetup = 8;
constexpr std::size_t kMostPaidFor = 4;  ///< setups; more of them share the budget

/// Its timing beside its values where that was fitted, too.
TestCandidate candidate(const FittedCandidate& one, const CompiledModel& model, double command_interval) {
  TestCandidate candidate{one.name, one.definition, model, one.values, {}};
  if (one.timing) {
    candidate.command_interval = command_interval;
    candidate.command_shift = *one.timing;
  }
  const Eigen::Index fitted = candidate.coordinates();
  candidate.covariance = one.covariance.topLeftCorner(fitted, fitted);
  return candidate;
}

double longest(const std::vector<Trial>& trials) {
  double most = 0.0;
  for (const Trial& trial : trials)
    most = std::max(most, trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0));
  return std::min(most, kLongest);
}

}  // namespace

std::optional<NextTest> propose_test(const PluginCatalog& catalog, const Experiment& experiment,
                                     const FittedCandidate& one, const FittedCandidate& other,
                                     const std::vector<Trial>& trials, const ConditionsAt& conditions_at,
                                     std::uint64_t seed, const Work& work) {
  TestSpace space = test_space(one.definition.structure.robot, one.definition.engine, longest(trials));
  limit_to_trials(space, trials);
  TestConditions conditions = conditions_at(space.control_period);
  std::vector<KnownSetup> setups = known_setups(one.definition, experiment.target.recording);
  const int more = kMoreForASetup * static_cast<int>(std::min(setups.size(), kMostPaidFor) - 1);
  const double interval = longest_command_interval(trials);
  const std::unique_ptr<CompiledModel> first = compile(one.definition.structure, one.definition.engine),
                                       second = compile(other.definition.structure, other.definition.engine);
  NextTestTask task{.catalog = catalog,
                    .candidates = {candidate(one, *first, interval), candidate(other, *second, interval)},
                    .noise = std::move(conditions.noise),
                    .space = std::move(space),
                    .start = std::move(conditions.start),
                    .start_deviation = std::move(conditions.start_deviation),
                    .setups = std::move(setups),
                    .evaluations = kEvaluations + more,
                    .seed = seed,
                    .work = work};
  try {
    return next_test(task);
  } catch (const Interrupted&) {
    throw;
  } catch (const Error&) {  // no limits, or the plugin is missing: a diagnosis without a proposal
  }
  return std::nullopt;
}

}  // namespace lacuna
