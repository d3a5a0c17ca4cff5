#include "app/workspace/integration.h"

#include "config/decided.h"
#include "fitting/substeps.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr int kFarMore = 4;  ///< times as many as are needed: worth a word

/// "articulated, step 2.50 ms": of one integration step.
std::string steps_of(const EngineSettings& engine, int substeps) {
  return fmt::format("{}, step {}", engine.engine, format_quantity(engine.step / substeps, "s"));
}

std::string percent(double share) {
  return share < 0.1 ? fmt::format("{:.2g} %", 100.0 * share) : fmt::format("{:.0f} %", 100.0 * share);
}

std::string error_of(const Substeps& found) {
  std::string text = percent(found.share) + " of the uncertainty of a free run from noise and initial state";
  if (!found.shift.address.empty())
    text += fmt::format("; largest shift of a fitted value: {} by {} of half its 95 % interval", found.shift.address,
                        percent(found.shift.share));
  return text;
}

std::string sentence_of(const EngineSettings& engine, const Substeps& found) {
  const std::string steps = steps_of(engine, found.count);
  if (!std::isfinite(found.share))
    return fmt::format("integration ({}): the model cannot be simulated at its start values", steps);
  if (found.enough) return fmt::format("integration error ({}) is negligible: {}", steps, error_of(found));
  return fmt::format(
      "integration error ({}) is not negligible: {}. Set a shorter engine.step, or fit over shorter segments "
      "(fit.horizon)",
      steps, error_of(found));
}

}  // namespace

std::string settle_substeps(OpenExperiment& opened, const std::vector<Trial>& trials, const Work& work,
                            TrialsFor trials_for) {
  EngineSettings& engine = opened.definition.engine;
  if (substeps_decided(opened.experiment)) return {};
  if (engine.engine == "ode") {
    decide_substeps(opened.experiment, 1);
    engine.substeps = opened.experiment.engine.substeps;
    return {};
  }
  if (trials.empty()) return {};
  const std::vector<double> values = opened.definition.start_values();
  if (engine.substeps > 0 && engine.substeps < kFarMore) return {};
  const Substeps found =
      sufficient_substeps(opened.definition, trials, values, work, trials_for, opened.experiment.fit);
  if (opened.experiment.engine.substeps == 0) {
    decide_substeps(opened.experiment, found.count);
    engine.substeps = found.count;
    opened.model = compile(opened.definition.structure, engine);
    return sentence_of(engine, found);
  }
  if (!found.enough || !std::isfinite(found.share) || engine.substeps < kFarMore * found.count) return {};
  return fmt::format(
      "engine.substeps = {} is more than needed: with {} the integration error is negligible ({}). Without "
      "engine.substeps the program chooses the number",
      engine.substeps, found.count, error_of(found));
}

}  // namespace lacuna
