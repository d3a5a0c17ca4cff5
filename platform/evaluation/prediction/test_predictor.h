#pragma once

#include <lacuna/test_fitness.h>

#include "evaluation/scoring/candidate_simulator.h"
#include "foundation/work.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// Predicts tests with models. The compiled model, and the definition where models may have their own robot or lack
/// effects, must outlive it.
class TestPredictor {
 public:
  /// `times`: when sensors are read, s; makes a workspace for each thread of `work`. `models`: how many take turns, so
  /// that their own robots stay compiled. `start`: when tests begin, s.
  TestPredictor(const CompiledModel& model, std::vector<double> times, const Work& work,
                const ModelDefinition* definition = nullptr, std::size_t models = 1, double start = 0.0);
  ~TestPredictor();

  int workers() const { return static_cast<int>(simulators_.size()); }
  /// Fills `prediction`, reusing its memory, and adds the steps taken to `steps`. False: the model cannot carry the
  /// test out; `reason` says why.
  bool predict(const ModelProposal& candidate, const Test& test, int worker, TestPrediction& prediction,
               std::uint64_t& steps, std::string& reason) const;

 private:
  struct Desk;
  std::vector<double> times_;
  std::vector<std::unique_ptr<Desk>> simulators_;
};

}  // namespace lacuna
