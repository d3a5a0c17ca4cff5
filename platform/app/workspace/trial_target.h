#pragma once

#include "config/schema/experiment.h"
#include "evaluation/prediction/target_simulator.h"
#include "foundation/processes/guarded_call.h"
#include "loading/plugin_catalog.h"

#include <cstdint>
#include <memory>
#include <string>

namespace lacuna {

/// The target of an experiment, to carry single tests out on.
class TrialTarget {
 public:
  /// `model`: what an outside target is held against. `replicate`: whose hidden values a simulated target has (see
  /// `target.redraw`). Experiment, model and catalog must live as long. An outside target is not started yet.
  TrialTarget(const Experiment& experiment, const ModelDefinition& model, const PluginCatalog& catalog, int replicate,
              const Stop& stop);

  bool takes_tests() const { return system_->takes_tests(); }
  /// The robot that a simulated target is; null for another one.
  const RobotSpec* robot() const { return definition_ ? &definition_->structure.robot : nullptr; }
  /// SHA-256 of what the target is, so that trials of another one are told apart: of a simulated one with its hidden
  /// values, for a program its version: its other keys only say how it is run.
  const std::string& digest() const { return digest_; }
  /// The `number`th trial; `seed` and the number key its noise. Throws `Error` where the target cannot.
  Trial carry_out(const Test& test, std::uint64_t seed, std::uint64_t number);

 private:
  const Experiment& experiment_;
  const ModelDefinition& model_;
  Stop stop_;
  std::unique_ptr<TargetSystem> system_;
  ComponentOrigin origin_;
  std::unique_ptr<ModelDefinition> definition_;
  std::vector<double> hidden_;
  std::string digest_;
};

}  // namespace lacuna
