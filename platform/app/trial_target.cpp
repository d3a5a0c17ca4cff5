#include "app/trial_target.h"

#include "evaluation/hidden_truth.h"
#include "foundation/digest.h"
#include "storage/canonical_text.h"

#include <lacuna/random_stream.h>

#include <fmt/format.h>

#include <array>

namespace lacuna {
namespace {

constexpr std::uint64_t kSingleTrials = 0x7472'6961'6c73;  // apart from the streams of runs

}  // namespace

TrialTarget::TrialTarget(const Experiment& experiment, const PluginCatalog& catalog, int replicate)
    : system_(catalog.make<TargetSystem>(experiment.target.kind)),
      origin_(catalog.origin<TargetSystem>(experiment.target.kind)) {
  std::string description = experiment.target.kind;
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
  std::unique_ptr<TargetSimulator> simulator;
  if (definition_) {
    const std::uint64_t noise = RandomStream(std::array{kSingleTrials, seed})();
    simulator = std::make_unique<TargetSimulator>(*definition_, hidden_, noise);
    simulator->begin_trial(number);
  }
  return guarded_call(origin_, "carrying a test out",
                      [&] { return system_->carry_out(test, {.trials = nullptr, .simulator = simulator.get()}); });
}

}  // namespace lacuna
