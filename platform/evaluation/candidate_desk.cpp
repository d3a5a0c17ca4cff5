#include "evaluation/candidate_desk.h"

#include <lacuna/error.h>

#include <algorithm>
#include <utility>

namespace lacuna {

/// A compiled model with memory to simulate it in.
struct CandidateDesk::Bench {
  explicit Bench(const CompiledModel& shared) : model(shared), workspace(model.make_workspace()) {}
  Bench(std::unique_ptr<CompiledModel> compiled, std::shared_ptr<const RobotSpec> from)
      : robot(std::move(from)), owned(std::move(compiled)), model(*owned), workspace(model.make_workspace()) {}

  std::shared_ptr<const RobotSpec> robot;  // shared with whoever proposed it, so that its address means it alone
  std::unique_ptr<CompiledModel> owned;
  const CompiledModel& model;
  std::unique_ptr<Workspace> workspace;
};

CandidateDesk::CandidateDesk(const CompiledModel& shared, const ModelDefinition* definition, std::size_t kept)
    : definition_(definition), kept_(std::max<std::size_t>(kept, 1)), shared_(std::make_unique<Bench>(shared)) {}

CandidateDesk::~CandidateDesk() = default;
CandidateDesk::CandidateDesk(CandidateDesk&&) noexcept = default;

void CandidateDesk::take(const ModelProposal& candidate) {
  taken_ = candidate.robot ? &bench_of(candidate.robot) : shared_.get();
  values_ = &candidate.values;
}

const CandidateDesk::Bench& CandidateDesk::bench_of(const std::shared_ptr<const RobotSpec>& robot) {
  for (const std::unique_ptr<Bench>& bench : own_)
    if (bench->robot == robot) return *bench;
  if (!definition_) throw Error("a robot of its own can be simulated by the algorithm's phases only");
  const ModelStructure& model = definition_->structure;
  auto compiled = compile({*robot, model.effects, model.parameters}, definition_->engine);
  own_.push_back(std::make_unique<Bench>(std::move(compiled), robot));
  if (own_.size() > kept_) own_.erase(own_.begin());
  return *own_.back();
}

void CandidateDesk::simulate(const Test& test, const SimulationOptions& options, SimulationResult& result) {
  taken_->model.simulate(*values_, test, options, *taken_->workspace, result);
}

}  // namespace lacuna
