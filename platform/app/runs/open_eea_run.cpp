#include "app/runs/open_eea_run.h"

#include "app/workspace/integration.h"
#include "eea/trials/recorded_trials.h"
#include "evaluation/model/complaints.h"
#include "evaluation/model/hidden_truth.h"
#include "foundation/address.h"
#include "foundation/parallel.h"
#include "foundation/processes/stop.h"

#include <lacuna/random_stream.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace lacuna {
namespace {

constexpr std::uint64_t kImagined = 0x696d'6167'696e;  // apart from the streams of runs
constexpr std::uint64_t kImaginedTrials = 4;

bool is_simulated(const OpenExperiment& opened) { return opened.experiment.target.kind == "simulated"; }

/// Whether tests answer to sensors. One that cannot be made says nothing against it.
bool makes_controllers(const EeaDefinition& definition) {
  RandomStream any(std::array<std::uint64_t, 1>{1});
  try {
    const Test test = definition.decode_test(definition.exploration.breeder->random(any));
    return !std::holds_alternative<CommandSeries>(test.drive);
  } catch (const Error&) {
    return true;
  }
}

/// Why a controller that was made for the model's channels cannot read the target's: it knows them by their places.
/// `seen`: which of the model's; none: all. Empty: it can.
std::string other_readings(const RobotSpec& model, const RobotSpec& target, std::vector<std::size_t> seen) {
  const std::vector<Channel> wanted = sensor_channels(model), there = sensor_channels(target);
  if (seen.empty())
    for (std::size_t c = 0; c < wanted.size(); ++c) seen.push_back(c);
  for (const std::size_t c : seen)
    if (c >= there.size() || there[c].name != wanted[c].name)
      return "the controller sees \"" + wanted[c].name + "\", reading " + std::to_string(c + 1) +
             " of the model's robot; the target's has " +
             (c < there.size() ? "\"" + there[c].name + "\" there" : std::to_string(there.size()) + " readings") +
             "; give both robots the same sensors in the same order, or name the shared ones";
  return {};
}

void check_controllers(const EeaDefinition& definition, const Experiment& experiment, const RobotSpec& target,
                       Complaints& complaints) {
  const RobotSpec& model = definition.model.structure.robot;
  if (const std::string problem = other_readings(model, target, definition.seen_channels); !problem.empty())
    complaints.add(experiment.test.sensors.empty() ? "target.robot" : "test.sensors", problem);
  if (command_channels(model) != command_channels(target))
    complaints.add(
        "target.robot",
        "its actuators differ from those of the model's robot, and controllers need the same ones in the same order");
}

/// A channel without measurements would count as right whatever a model predicts.
void check_readings(const EeaDefinition& definition, const RobotSpec& target, Complaints& complaints) {
  const std::vector<Channel> there = sensor_channels(target);
  std::string missing;
  for (const Channel& channel : sensor_channels(definition.model.structure.robot)) {
    const std::vector<std::string>& scored = definition.scored_channels;
    if (!scored.empty() && std::find(scored.begin(), scored.end(), channel.name) == scored.end()) continue;
    const bool read = std::any_of(there.begin(), there.end(), [&](const Channel& c) { return c.name == channel.name; });
    if (!read) missing += (missing.empty() ? "\"" : ", \"") + channel.name + "\"";
  }
  if (missing.empty()) return;
  complaints.add(
      "estimation.sensors",
      "models would be scored on " + missing +
          ", which the target does not measure; give both robots the same sensors, or name the shared ones here");
}

bool takes_tests(const OpenExperiment& opened) {
  return opened.catalog->make<TargetSystem>(opened.experiment.target.kind)->takes_tests();
}

/// What the model does in tests as the exploration begins with. Of those that it cannot carry out there are none.
std::vector<Trial> imagined_trials(const EeaDefinition& definition, const Stop& stop) {
  RandomStream random(std::array<std::uint64_t, 1>{kImagined});
  TargetSimulator simulator(definition.model, definition.model.start_values(), kImagined, stop);
  std::vector<Trial> trials;
  for (std::uint64_t i = 0; i < kImaginedTrials; ++i) try {
      simulator.begin_trial(i);
      trials.push_back(simulator.simulate(definition.decode_test(definition.exploration.breeder->random(random))));
    } catch (const Interrupted&) {
      throw;
    } catch (const Error&) {
      continue;
    }
  return trials;
}

/// With the integration steps that the model needs, where the experiment leaves them open.
OpenExperiment with_substeps(OpenExperiment opened) {
  if (opened.experiment.engine.substeps > 0) return opened;
  const bool needs_none = opened.definition.engine.engine == "ode";
  const std::vector<Trial> trials =
      needs_none ? std::vector<Trial>()
      : takes_tests(opened)
          ? imagined_trials(EeaDefinition(opened.experiment, *opened.catalog, opened.definition, true), opened.stop)
          : opened.fit_trials();
  settle_substeps(opened, trials, {default_threads(), opened.stop},
                  takes_tests(opened) ? TrialsFor::motion : TrialsFor::fit);
  return opened;
}

}  // namespace

OpenEeaRun::OpenEeaRun(OpenExperiment opened)
    : opened_(with_substeps(std::move(opened))),
      target_(is_simulated(opened_)
                  ? std::make_unique<ModelDefinition>(define_target(opened_.experiment, *opened_.catalog))
                  : nullptr),
      takes_tests_(lacuna::takes_tests(opened_)),
      definition_(
          std::make_unique<EeaDefinition>(opened_.experiment, *opened_.catalog, opened_.definition, takes_tests_)) {
  if (!takes_tests_ || !target_) return;
  const RobotSpec& target = target_->structure.robot;
  Complaints complaints(opened_.experiment);
  check_readings(*definition_, target, complaints);
  if (makes_controllers(*definition_)) check_controllers(*definition_, opened_.experiment, target, complaints);
  complaints.throw_if_any();
}

std::vector<double> OpenEeaRun::hidden_values(int replicate) const {
  if (!target_) return {};
  return draw_hidden_values(*target_, opened_.experiment.target.simulated, replicate);
}

std::vector<double> OpenEeaRun::truth(int replicate) const {
  if (!target_) return {};
  return true_values(opened_.definition, *target_, hidden_values(replicate));
}

std::optional<Hello> ask_target(const OpenEeaRun& opened) {
  const Experiment& experiment = opened.opened().experiment;
  const std::unique_ptr<ProcessTarget> program =
      outside_target(experiment, opened.opened().definition, 1, opened.opened().stop);
  if (!program) return std::nullopt;
  const Hello hello = program->hello();
  const EeaDefinition& definition = opened.definition();
  RandomStream any(std::array<std::uint64_t, 1>{1});
  const Test test = definition.decode_test(definition.exploration.breeder->random(any));
  if (!hello.exchanges && !std::holds_alternative<CommandSeries>(test.drive))
    throw_problem(experiment.where("test.encoding"),
                  "test.encoding: " + definition.test_encoding.origin.name +
                      " makes controllers, but the target takes only whole command series; write encoding = "
                      "\"command_series\"");
  return hello;
}

ReplicateTarget::ReplicateTarget(const OpenEeaRun& opened, std::uint64_t seed, int replicate, TargetNotes notes)
    : system_(opened.opened().catalog->make<TargetSystem>(opened.opened().experiment.target.kind)),
      origin_(opened.opened().catalog->origin<TargetSystem>(opened.opened().experiment.target.kind)) {
  const Experiment& experiment = opened.opened().experiment;
  const std::uint64_t noise = RandomStream(std::array{seed, static_cast<std::uint64_t>(replicate)})();
  if (opened.target())
    simulator_ = std::make_unique<TargetSimulator>(*opened.target(), opened.hidden_values(replicate), noise,
                                                   opened.opened().stop);
  program_ = outside_target(experiment, opened.opened().definition, noise, opened.opened().stop, std::move(notes));
  if (!program_) return;
  repeats_ = experiment.target.process.repeats;
  pause_ = experiment.target.process.pause;
}

EeaState beginning(const OpenEeaRun& opened) {
  EeaState state = first_state(opened.definition());
  if (opened.takes_tests()) return state;
  state.phase = Phase::estimation;
  state.trials = recorded_trials(opened.definition(), opened.opened().fit_trials());
  return state;
}

}  // namespace lacuna
