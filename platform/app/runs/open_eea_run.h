#pragma once

#include "app/terminal/options.h"
#include "app/workspace/outside_target.h"
#include "app/workspace/open_experiment.h"
#include "eea/eea_loop.h"

#include <memory>
#include <optional>
#include <vector>

namespace lacuna {

/// An experiment made ready for the Estimation-Exploration Algorithm. Const and shared by its replicates.
class OpenEeaRun {
 public:
  /// Throws `BadInput` with every problem of the experiment.
  explicit OpenEeaRun(OpenExperiment opened);

  const OpenExperiment& opened() const { return opened_; }
  const EeaDefinition& definition() const { return *definition_; }
  bool takes_tests() const { return takes_tests_; }
  /// The robot of a simulated target; none of a recorded one.
  const ModelDefinition* target() const { return target_.get(); }

  /// Hidden values of the target in that replicate; empty if it is not simulated.
  std::vector<double> hidden_values(int replicate) const;
  /// The same for the model's free values; NaN where the target has no such value.
  std::vector<double> truth(int replicate) const;

 private:
  OpenExperiment opened_;
  std::unique_ptr<ModelDefinition> target_;
  bool takes_tests_;
  std::unique_ptr<EeaDefinition> definition_;
};

/// What an outside target says of itself; nothing of another kind. Starts it and ends it again. Throws `BadInput` with
/// everything in which it does not fit the experiment, `Error` where it fails.
std::optional<Hello> ask_target(const OpenEeaRun& opened);

/// A replicate's own target.
class ReplicateTarget {
 public:
  /// An outside target is started by its first trial.
  ReplicateTarget(const OpenEeaRun& opened, std::uint64_t seed, int replicate, TargetNotes notes = {});
  EeaTarget target() const { return {*system_, origin_, simulator_.get(), program_.get(), repeats_, pause_}; }

 private:
  std::unique_ptr<TargetSystem> system_;
  ComponentOrigin origin_;
  std::unique_ptr<TargetSimulator> simulator_;
  std::unique_ptr<ProcessTarget> program_;
  int repeats_ = 0;
  double pause_ = 0.0;
};

/// Where a replicate begins: the first state, with the trials that a recorded target has.
EeaState beginning(const OpenEeaRun& opened);

}  // namespace lacuna
