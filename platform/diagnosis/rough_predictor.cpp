#include "diagnosis/rough_predictor.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr int kRougher = 4, kFewest = 2;  ///< times fewer substeps, and how many there are at least

bool may_touch(const RobotSpec& robot) {
  return robot.contact.ground && std::any_of(robot.bodies.begin(), robot.bodies.end(),
                                             [](const BodySpec& body) { return !body.shapes.empty(); });
}

}  // namespace

EngineSettings for_differences(const ModelDefinition& definition) {
  EngineSettings engine = definition.engine;
  if (may_touch(definition.structure.robot)) return engine;
  engine.substeps = std::min(engine.substeps, std::max(kFewest, engine.substeps / kRougher));
  return engine;
}

RoughPredictor::RoughPredictor(const ModelDefinition& definition, const BaseSolution& base, int workers,
                               Timing timing) {
  const EngineSettings engine = for_differences(definition);
  if (base.free_run || engine.substeps == definition.engine.substeps) return;
  model_ = compile(definition.structure, engine);
  predictor_ = std::make_unique<TrialPredictor>(*model_, base.trials, workers, timing);
}

}  // namespace lacuna
