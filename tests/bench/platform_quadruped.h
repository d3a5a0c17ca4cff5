#pragma once

#include "simulation/compiled_model.h"

#include <memory>
#include <vector>

namespace lacuna {

/// The same quadruped through the platform: compiled once, simulated in one workspace.
class PlatformQuadruped {
 public:
  PlatformQuadruped();

  /// A trial of `steps` steps with a reading after each. Throws `Error` unless it completes.
  void run(int steps);
  const SimulationResult& result() const { return result_; }
  const Test& test() const { return test_; }

 private:
  std::unique_ptr<CompiledModel> model_;
  std::unique_ptr<Workspace> workspace_;
  Test test_;
  std::vector<double> times_;
  SimulationResult result_;
};

}  // namespace lacuna
