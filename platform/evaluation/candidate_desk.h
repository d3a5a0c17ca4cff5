#pragma once

#include <lacuna/model_encoding.h>

#include "evaluation/model_definition.h"

#include <memory>

namespace lacuna {

/// Where one thread simulates one candidate after another: with values alone on the compiled model that all share, with
/// a robot of its own on one that is compiled for it and kept until another robot comes. One thread at a time; the same
/// candidate gives the same bits whatever came before.
class CandidateDesk {
 public:
  /// `shared` must outlive the desk. `definition` is what a candidate's own robot is compiled with, and must outlive
  /// it, too; without one no candidate may bring a robot.
  CandidateDesk(const CompiledModel& shared, const ModelDefinition* definition);
  ~CandidateDesk();
  CandidateDesk(CandidateDesk&&) noexcept;

  /// Makes ready for a candidate, which must live until the last simulation. Throws `Error` for a robot that cannot be
  /// compiled.
  void take(const ModelProposal& candidate);
  /// Simulates what was taken (simulation/compiled_model.h).
  void simulate(const Test& test, const SimulationOptions& options, SimulationResult& result);

 private:
  struct Bench;
  const ModelDefinition* definition_;
  std::unique_ptr<Bench> shared_, own_;
  std::shared_ptr<const RobotSpec> robot_;  ///< shared with whoever proposed it: what `own_` is compiled from
  const Bench* taken_ = nullptr;
  const std::vector<double>* values_ = nullptr;
};

}  // namespace lacuna
