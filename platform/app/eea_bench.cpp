#include "app/eea_bench.h"

#include "eea/recorded_trials.h"
#include "evaluation/hidden_truth.h"

#include <lacuna/random_stream.h>

#include <array>
#include <utility>

namespace lacuna {
namespace {

bool is_simulated(const Rig& rig) { return rig.experiment.target.kind == "simulated"; }

}  // namespace

EeaBench::EeaBench(Rig rig)
    : rig_(std::move(rig)),
      target_(is_simulated(rig_) ? std::make_unique<ModelDefinition>(define_target(rig_.experiment, *rig_.catalog))
                                 : nullptr),
      takes_tests_(rig_.catalog->make<TargetSystem>(rig_.experiment.target.kind)->takes_tests()),
      definition_(std::make_unique<EeaDefinition>(rig_.experiment, *rig_.catalog, rig_.definition, takes_tests_)) {}

std::vector<double> EeaBench::hidden_values(int replicate) const {
  if (!target_) return {};
  return draw_hidden_values(*target_, rig_.experiment.target.simulated, replicate);
}

std::vector<double> EeaBench::truth(int replicate) const {
  if (!target_) return {};
  return true_values(rig_.definition, *target_, hidden_values(replicate));
}

ReplicateTarget::ReplicateTarget(const EeaBench& bench, std::uint64_t seed, int replicate)
    : system_(bench.rig().catalog->make<TargetSystem>(bench.rig().experiment.target.kind)),
      origin_(bench.rig().catalog->origin<TargetSystem>(bench.rig().experiment.target.kind)) {
  if (!bench.target()) return;
  RandomStream noise(std::array<std::uint64_t, 2>{seed, static_cast<std::uint64_t>(replicate)});
  simulator_ = std::make_unique<TargetSimulator>(*bench.target(), bench.hidden_values(replicate), noise());
}

EeaState beginning(const EeaBench& bench) {
  EeaState state = first_state(bench.definition());
  if (bench.takes_tests()) return state;
  state.phase = Phase::estimation;
  state.trials = recorded_trials(bench.definition(), bench.rig().fit_trials());
  return state;
}

}  // namespace lacuna
