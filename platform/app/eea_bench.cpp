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

std::optional<Hello> ask_target(const EeaBench& bench) {
  const Experiment& experiment = bench.rig().experiment;
  const std::unique_ptr<ProcessTarget> program = outside_target(experiment, bench.rig().definition, 1);
  if (!program) return std::nullopt;
  const Hello hello = program->hello();
  const EeaDefinition& definition = bench.definition();
  RandomStream any(std::array<std::uint64_t, 1>{1});
  const Test test = definition.decode_test(definition.exploration.breeder->random(any));
  if (!hello.exchanges && !std::holds_alternative<CommandSeries>(test.drive))
    throw_problem(experiment.where("test.encoding"),
                  "test.encoding: " + definition.test_encoding.origin.name +
                      " makes controllers, and the target takes whole command series only; write encoding = "
                      "\"command_series\"");
  return hello;
}

ReplicateTarget::ReplicateTarget(const EeaBench& bench, std::uint64_t seed, int replicate, TargetNotes notes)
    : system_(bench.rig().catalog->make<TargetSystem>(bench.rig().experiment.target.kind)),
      origin_(bench.rig().catalog->origin<TargetSystem>(bench.rig().experiment.target.kind)) {
  const Experiment& experiment = bench.rig().experiment;
  const std::uint64_t noise = RandomStream(std::array{seed, static_cast<std::uint64_t>(replicate)})();
  if (bench.target())
    simulator_ = std::make_unique<TargetSimulator>(*bench.target(), bench.hidden_values(replicate), noise);
  program_ = outside_target(experiment, bench.rig().definition, noise, std::move(notes));
  if (program_) repeats_ = experiment.target.process.repeats;
}

EeaState beginning(const EeaBench& bench) {
  EeaState state = first_state(bench.definition());
  if (bench.takes_tests()) return state;
  state.phase = Phase::estimation;
  state.trials = recorded_trials(bench.definition(), bench.rig().fit_trials());
  return state;
}

}  // namespace lacuna
