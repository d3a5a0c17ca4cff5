#include "config/decided.h"

#include "config/schema/experiment_schema.h"
#include "config/overrides.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr const char* kSubsteps = "engine.substeps=";

}  // namespace

void decide_engine(Experiment& experiment, const std::string& engine) {
  if (!experiment.engine.engine.empty()) return;
  experiment.engine.engine = engine;
  experiment.decided.push_back(fmt::format("engine.engine=\"{}\"", engine));
}

void decide_substeps(Experiment& experiment, int substeps) {
  if (experiment.engine.substeps != 0) return;
  experiment.engine.substeps = substeps;
  experiment.decided.push_back(kSubsteps + std::to_string(substeps));
}

bool substeps_decided(const Experiment& experiment) {
  return std::any_of(experiment.decided.begin(), experiment.decided.end(),
                     [](const std::string& one) { return one.starts_with(kSubsteps); });
}

void decide_as(Experiment& experiment, const std::vector<std::string>& decided) {
  if (decided.empty()) return;
  TomlNode tree;
  ProblemList problems;
  apply_overrides(tree, decided, problems);
  Reading reading(problems, {});
  EngineSettings then;
  static const Value<EngineSettings> kKeys = engine_keys().value();
  if (const TomlNode* engine = tree.find("engine")) kKeys.read(*engine, reading, then);
  problems.throw_if_any();
  if (!then.engine.empty()) decide_engine(experiment, then.engine);
  if (then.substeps > 0) decide_substeps(experiment, then.substeps);
}

}  // namespace lacuna
