#include "app/workspace/integration.h"

#include "config/decided.h"
#include "fitting/substeps.h"
#include "foundation/parallel.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr int kFarMore = 4;  ///< times as many as are needed: worth a word

std::string steps_of(int count, double step) {
  const std::string each = format_quantity(step, "s");
  return count == 1 ? "one step in each of " + each : fmt::format("{} steps in each of {}", count, each);
}

std::string shift_of(const Substeps& found) {
  if (found.shift.address.empty()) return "";
  return fmt::format("; largest effect on a fitted value: {} by {:.2g} of half its 95 % interval", found.shift.address,
                     found.shift.share);
}

std::string error_of(const Substeps& found) {
  if (!std::isfinite(found.share)) return "the model cannot be simulated at its start values";
  return fmt::format("error of a free run {:.2g} × the uncertainty from noise and initial state", found.share) +
         shift_of(found);
}

std::string sentence_of(const EngineSettings& engine, const Substeps& found) {
  return fmt::format("integration: {}, {}: {}{}", engine.engine, steps_of(found.count, engine.step), error_of(found),
                     found.enough ? "" : "; more steps bring little");
}

}  // namespace

std::string settle_substeps(OpenExperiment& opened, const std::vector<Trial>& trials, int threads,
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
  const Substeps found = sufficient_substeps(
      opened.definition, trials, values, threads > 0 ? threads : default_threads(), trials_for, opened.experiment.fit);
  if (opened.experiment.engine.substeps == 0) {
    decide_substeps(opened.experiment, found.count);
    engine.substeps = found.count;
    opened.model = compile(opened.definition.structure, engine);
    return sentence_of(engine, found);
  }
  if (!found.enough || engine.substeps < kFarMore * found.count) return {};
  return fmt::format(
      "integration: {}, {}, as written in the file; {} suffice: {}. Without engine.substeps the program chooses the "
      "number",
      engine.engine, steps_of(engine.substeps, engine.step), found.count, error_of(found));
}

}  // namespace lacuna
