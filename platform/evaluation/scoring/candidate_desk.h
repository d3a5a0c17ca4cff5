#pragma once

#include <lacuna/model_encoding.h>

#include "evaluation/model/model_definition.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace lacuna {

/// Where one thread simulates one candidate after another: with values alone on the compiled model that all share, with
/// a robot of its own or without some of the effects on one that is compiled for it, of which the last few are kept.
/// One thread at a time; the same candidate gives the same bits whatever came before.
class CandidateDesk {
 public:
  /// `shared` must outlive the desk. `definition` is what a candidate's own robot, or one without some effects, is
  /// compiled with, and must outlive it, too; without one no candidate may bring either. `kept`: how many of the last
  /// own robots stay compiled, at least one; as many as candidates take turns. Of the shared robot 32 sets of effects
  /// stay compiled: all that five switches make.
  CandidateDesk(const CompiledModel& shared, const ModelDefinition* definition, std::size_t kept = 1);
  ~CandidateDesk();
  CandidateDesk(CandidateDesk&&) noexcept;

  /// Makes ready for a candidate, which must live until the last simulation. Throws `Error` for a robot that cannot be
  /// compiled; the desk is as it was before, then.
  void take(const ModelProposal& candidate);
  /// Simulates what was taken (simulation/compiled_model.h).
  void simulate(const Test& test, const SimulationOptions& options, SimulationResult& result);

 private:
  struct Bench;
  using Benches = std::vector<std::unique_ptr<Bench>>;  // the one used last at the end
  const Bench& bench_of(const ModelProposal& candidate, Benches& benches, std::size_t most);

  const ModelDefinition* definition_;
  std::size_t kept_;
  std::unique_ptr<Bench> shared_;
  Benches own_;       ///< of candidates' own robots
  Benches switched_;  ///< of the shared robot without some of the effects
  const Bench* taken_ = nullptr;
  std::span<const double> values_;
  std::vector<double> kept_values_;  ///< what `values_` shows of a candidate without some effects
};

}  // namespace lacuna
