#pragma once

#include "answer/diagnosis.h"
#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"
#include "fitting/numerics/progress.h"
#include "search/kept_fits.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// What is diagnosed. Everything referred to must live until `find_missing_effects` returns.
struct DiagnosisTask {
  const Experiment& experiment;
  const PluginCatalog& catalog;
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;     ///< held-out ones are looked at once the answer stands
  std::vector<std::string> among = {};  ///< effects to try; empty: all
  std::uint64_t seed = 1;               ///< of the test that is proposed
  int threads = 1;
  ProgressCallback progress = {};
  const KeptFits* known = nullptr;                 ///< of an earlier call for the same; null: none
  std::function<void(const KeptFits&)> keep = {};  ///< gets all fits after each, for a later call
};

/// METHOD: what effects, if any, the model lacks (docs/explanation/diagnosis.md). Doubts about the data stand beside
/// the verdict. Where the time limit is reached (foundation/processes/interrupt.h), it is lifted and the diagnosis is
/// `stopped`. Throws `Error` where the trials do not fit the model, and `Interrupted`.
Diagnosis find_missing_effects(const DiagnosisTask& task);

}  // namespace lacuna
