#pragma once

#include <lacuna/model_encoding.h>

#include "evaluation/model/model_definition.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace lacuna {

/// With it one thread simulates one candidate after another: a candidate with other values only, on the
/// compiled model that all share; one with its own robot, or without some effects, on a model compiled for it, of which
/// the last few are kept. One thread at a time; the same candidate gives the same bits whatever came before.
class CandidateSimulator {
 public:
  /// `shared` must outlive the simulator. `definition` is the base for compiling a candidate's own robot or smaller set
  /// of effects, and must outlive it, too; without it no candidate may have either. `kept`: how many of the last own
  /// robots stay compiled, at least one; as many as candidates take turns. For the shared robot 32 sets of effects stay
  /// compiled: all combinations of five switches.
  CandidateSimulator(const CompiledModel& shared, const ModelDefinition* definition, std::size_t kept = 1);
  ~CandidateSimulator();
  CandidateSimulator(CandidateSimulator&&) noexcept;

  /// Prepares for a candidate, which must live until the last simulation. Throws `Error` for a robot that cannot be
  /// compiled; the simulator then stays as it was.
  void take(const ModelProposal& candidate);
  /// Simulates the candidate of `take` (simulation/compiled_model.h).
  void simulate(const Test& test, const SimulationOptions& options, SimulationResult& result);

 private:
  struct CompiledCandidate;
  using CompiledCandidates = std::vector<std::unique_ptr<CompiledCandidate>>;  // the one used last at the end
  const CompiledCandidate& compiled_for(const ModelProposal& candidate, CompiledCandidates& compiled, std::size_t most);

  const ModelDefinition* definition_;
  std::size_t kept_;
  std::unique_ptr<CompiledCandidate> shared_;
  CompiledCandidates own_;       ///< of candidates' own robots
  CompiledCandidates switched_;  ///< for the shared robot without some of the effects
  const CompiledCandidate* taken_ = nullptr;
  std::span<const double> values_;
  std::vector<double> kept_values_;  ///< the part of `values_` for a candidate without some effects
};

}  // namespace lacuna
