#include "evaluation/scoring/candidate_simulator.h"

#include "evaluation/model/proposed_model.h"

#include <lacuna/error.h>

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

constexpr std::size_t kSetsOfEffects = 32;  // kept compiled: 30 kB each of a quadruped, which takes 0.2 ms to compile

}  // namespace

/// A compiled model with memory to simulate it in.
struct CandidateSimulator::CompiledCandidate {
  explicit CompiledCandidate(const CompiledModel& shared) : model(shared), workspace(model.make_workspace()) {}
  CompiledCandidate(const ModelProposal& of, const ModelDefinition& definition)
      : robot(of.robot),
        without(of.without),
        values(kept_values(of, definition)),
        owned(compile(structure_of(of, definition), definition.engine)),
        model(*owned),
        workspace(model.make_workspace()) {}

  bool is_of(const ModelProposal& candidate) const { return robot == candidate.robot && without == candidate.without; }

  std::shared_ptr<const RobotSpec> robot;  // shared with its creator, so that its address identifies it
  std::vector<std::size_t> without;
  std::vector<std::size_t> values;  // indices of a candidate's values that the model has
  std::unique_ptr<CompiledModel> owned;
  const CompiledModel& model;
  std::unique_ptr<Workspace> workspace;
};

CandidateSimulator::CandidateSimulator(const CompiledModel& shared, const ModelDefinition* definition, std::size_t kept)
    : definition_(definition),
      kept_(std::max<std::size_t>(kept, 1)),
      shared_(std::make_unique<CompiledCandidate>(shared)) {}

CandidateSimulator::~CandidateSimulator() = default;
CandidateSimulator::CandidateSimulator(CandidateSimulator&&) noexcept = default;

void CandidateSimulator::take(const ModelProposal& candidate) {
  if (candidate.robot)
    taken_ = &compiled_for(candidate, own_, kept_);
  else if (!candidate.without.empty())
    taken_ = &compiled_for(candidate, switched_, kSetsOfEffects);
  else
    taken_ = shared_.get();
  values_ = candidate.values;
  if (candidate.without.empty()) return;
  kept_values_.clear();
  for (const std::size_t value : taken_->values) kept_values_.push_back(candidate.values[value]);
  values_ = kept_values_;
}

const CandidateSimulator::CompiledCandidate& CandidateSimulator::compiled_for(const ModelProposal& candidate,
                                                                              CompiledCandidates& compiled,
                                                                              std::size_t most) {
  const auto known =
      std::find_if(compiled.begin(), compiled.end(), [&](const auto& one) { return one->is_of(candidate); });
  if (known != compiled.end()) {
    std::rotate(known, known + 1, compiled.end());
    return *compiled.back();
  }
  if (!definition_)
    throw Error(
        "a model with its own robot, or without some of the effects, can only be simulated in the phases of the "
        "algorithm");
  compiled.push_back(std::make_unique<CompiledCandidate>(candidate, *definition_));
  if (compiled.size() > most) compiled.erase(compiled.begin());
  return *compiled.back();
}

void CandidateSimulator::simulate(const Test& test, const SimulationOptions& options, SimulationResult& result) {
  taken_->model.simulate(values_, test, options, *taken_->workspace, result);
}

}  // namespace lacuna
