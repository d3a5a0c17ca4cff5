#include "app/workspace/trial_target.h"

#include "app/workspace/outside_target.h"
#include "evaluation/model/hidden_truth.h"
#include "foundation/digest.h"
#include "storage/core/canonical_text.h"

#include <lacuna/random_stream.h>

#include <fmt/format.h>

#include <array>
#include <cstdio>

namespace lacuna {
namespace {

constexpr std::uint64_t kSingleTrials = 0x7472'6961'6c73;  // apart from the streams of runs

void notes_to_user(const std::string& note) { fmt::print(stderr, "{}\n", note); }

}  // namespace

TrialTarget::TrialTarget(const Experiment& experiment, const ModelDefinition& model, const PluginCatalog& catalog,
                         int replicate, const Stop& stop)
    : experiment_(experiment),
      model_(model),
      stop_(stop),
      system_(catalog.make<TargetSystem>(experiment.target.kind)),
      origin_(catalog.origin<TargetSystem>(experiment.target.kind)) {
  std::string description = experiment.target.kind;
  if (experiment.target.kind == "process") description += "\nversion " + experiment.target.process.version + "\n";
  if (experiment.target.kind == "simulated") {
    definition_ = std::make_unique<ModelDefinition>(define_target(experiment, catalog));
    hidden_ = draw_hidden_values(*definition_, experiment.target.simulated, replicate);
    description += canonical_text(definition_->structure.robot) + canonical_text(definition_->effects);
    for (std::size_t i = 0; i < hidden_.size(); ++i)
      description += fmt::format("{} {}\n", definition_->free[i].address, hidden_[i]);
  }
  digest_ = sha256(description);
}

Trial TrialTarget::carry_out(const Test& test, std::uint64_t seed, std::uint64_t number) {
  const std::uint64_t noise = RandomStream(std::array{kSingleTrials, seed})();
  std::unique_ptr<TargetSimulator> simulator;
  if (definition_) {
    simulator = std::make_unique<TargetSimulator>(*definition_, hidden_, noise, stop_);
    simulator->begin_trial(number);
  }
  const std::unique_ptr<ProcessTarget> program = outside_target(experiment_, model_, noise, stop_, notes_to_user);
  if (program) program->begin_trial(number);
  const CallAllowance lasts(test.duration);
  return guarded_call(origin_, "carrying a test out", [&] {
    return system_->carry_out(test, {.simulator = simulator.get(), .program = program.get()});
  });
}

}  // namespace lacuna
