#include "app/integration.h"

#include "config/decided.h"
#include "fitting/substeps.h"
#include "foundation/parallel.h"
#include "foundation/unit.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

constexpr int kFarMore = 4;  ///< times as many as are needed: worth a word

std::string steps_of(int count, double step) {
  if (count == 1) return fmt::format("one step in each of {}", format_quantity(step, "s"));
  return fmt::format("{} steps in each of {}", count, format_quantity(step, "s"));
}

std::string error_of(const Substeps& found) {
  return fmt::format("what the integration does to a free run is {:.2g} of what noise and start leave open",
                     found.share);
}

std::string sentence_of(const EngineSettings& engine, const Substeps& found) {
  return fmt::format("integration: {}, {} ({}; {}{})", engine.engine, steps_of(found.count, engine.step),
                     "as many as needed", error_of(found),
                     found.enough ? "" : ", and more are not tried: the start values may be far off");
}

}  // namespace

std::string settle_substeps(Rig& rig, const std::vector<Trial>& trials, int threads) {
  if (trials.empty() || substeps_decided(rig.experiment)) return {};
  const std::vector<double> values = rig.definition.start_values();
  const Substeps found = sufficient_substeps(rig.definition, trials, values, threads > 0 ? threads : default_threads());
  EngineSettings& engine = rig.definition.engine;
  if (rig.experiment.engine.substeps == 0) {
    decide_substeps(rig.experiment, found.count);
    engine.substeps = found.count;
    rig.model = compile(rig.definition.structure, engine);
    return sentence_of(engine, found);
  }
  if (!found.enough || engine.substeps < kFarMore * found.count) return {};
  return fmt::format("integration: {}, {}, as the file says; {} would do ({}): engine.substeps = 0 leaves it open",
                     engine.engine, steps_of(engine.substeps, engine.step), found.count, error_of(found));
}

}  // namespace lacuna
