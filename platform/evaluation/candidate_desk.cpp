#include "evaluation/candidate_desk.h"

#include <lacuna/error.h>

namespace lacuna {

/// A compiled model with memory to simulate it in.
struct CandidateDesk::Bench {
  explicit Bench(const CompiledModel& shared) : model(shared), workspace(model.make_workspace()) {}
  explicit Bench(std::unique_ptr<CompiledModel> compiled)
      : owned(std::move(compiled)), model(*owned), workspace(model.make_workspace()) {}

  std::unique_ptr<CompiledModel> owned;
  const CompiledModel& model;
  std::unique_ptr<Workspace> workspace;
};

CandidateDesk::CandidateDesk(const CompiledModel& shared, const ModelDefinition* definition)
    : definition_(definition), shared_(std::make_unique<Bench>(shared)) {}

CandidateDesk::~CandidateDesk() = default;
CandidateDesk::CandidateDesk(CandidateDesk&&) noexcept = default;

void CandidateDesk::take(const ModelProposal& candidate) {
  values_ = &candidate.values;
  taken_ = shared_.get();
  if (!candidate.robot) return;
  if (candidate.robot != robot_) {
    if (!definition_) throw Error("a robot of its own can be simulated by the algorithm's phases only");
    robot_ = nullptr;
    own_.reset();
    ModelStructure structure = definition_->structure;
    structure.robot = *candidate.robot;
    own_ = std::make_unique<Bench>(compile(structure, definition_->engine));
    robot_ = candidate.robot;
  }
  taken_ = own_.get();
}

void CandidateDesk::simulate(const Test& test, const SimulationOptions& options, SimulationResult& result) {
  taken_->model.simulate(*values_, test, options, *taken_->workspace, result);
}

}  // namespace lacuna
