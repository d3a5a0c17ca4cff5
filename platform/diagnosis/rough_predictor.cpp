#include "diagnosis/rough_predictor.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr int kRougher = 4, kFewest = 2;  ///< times fewer substeps, and how many there are at least

}  // namespace

EngineSettings for_differences(EngineSettings engine) {
  engine.substeps = std::min(engine.substeps, std::max(kFewest, engine.substeps / kRougher));
  return engine;
}

RoughPredictor::RoughPredictor(const ModelDefinition& definition, const BaseSolution& base, int workers) {
  const EngineSettings engine = for_differences(definition.engine);
  if (base.free_run || engine.substeps == definition.engine.substeps) return;
  model_ = compile(definition.structure, engine);
  predictor_ = std::make_unique<TrialPredictor>(*model_, base.trials, workers);
}

}  // namespace lacuna
