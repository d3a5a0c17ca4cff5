#include "eea/stopping.h"

#include "foundation/text/counted.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kBetter = 0.99;  // of the smallest surprise so far, to count as progress

}  // namespace

void note_surprise(const EeaRun& run, EeaState& state, double surprise) {
  const int pass_of_best = state.pass - 1;
  if (run.definition.horizon(pass_of_best) != run.definition.horizon(pass_of_best - 1)) {
    state.least_surprise = kNotKnown;
    state.passes_without_progress = 0;
  }
  if (std::isnan(surprise)) return;
  if (std::isnan(state.least_surprise) || surprise < kBetter * state.least_surprise) {
    state.least_surprise = surprise;
    state.passes_without_progress = 0;
  } else {
    ++state.passes_without_progress;
  }
}

std::string lost_patience(const EeaRun& run, const EeaState& state) {
  const int patience = run.definition.patience;
  if (patience == 0 || state.passes_without_progress < patience) return {};
  return fmt::format("predictions of new trials have not improved for {} (smallest error {:.3g})",
                     counted(static_cast<std::size_t>(state.passes_without_progress), "pass"), state.least_surprise);
}

std::string too_little_to_learn(const EeaRun& run, const EeaState& state) {
  const EeaDefinition& definition = run.definition;
  const double fitness = state.counts.best_fitness;
  if (!definition.stop_below || !(fitness < *definition.stop_below)) return {};
  return fmt::format("the best test is worth {:.3g} {} ({}), which is below exploration.stop_below = {:g}", fitness,
                     definition.value.unit(), definition.value.name(), *definition.stop_below);
}

}  // namespace lacuna
