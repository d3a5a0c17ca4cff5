#pragma once

#include "answer/diagnosis.h"
#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"
#include "foundation/work.h"
#include "search/kept_fits.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// The task of a diagnosis. Everything that it refers to must live until `find_missing_effects` returns.
struct DiagnosisTask {
  const Experiment& experiment;
  const PluginCatalog& catalog;
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;     ///< held-out trials are read only after the answer is chosen
  std::vector<std::string> among = {};  ///< effects to try; empty: all
  std::uint64_t seed = 1;               ///< seed of the proposed test
  Work work = {};
  const KeptFits* known = nullptr;                 ///< fits of an earlier call for the same task; null: none
  std::function<void(const KeptFits&)> keep = {};  ///< receives all fits after each new one, for a later call
};

/// METHOD: which effects the model lacks (docs/explanation/diagnosis.md). The results of the data checks stand beside
/// the verdict. When the time limit of `work` is reached, the limit is lifted and the diagnosis is `stopped`. Throws
/// `Error` where the trials do not fit the model, and `Interrupted`.
Diagnosis find_missing_effects(const DiagnosisTask& task);

}  // namespace lacuna
