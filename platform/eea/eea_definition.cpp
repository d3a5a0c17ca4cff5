#include "eea/eea_definition.h"

#include "evaluation/channel_choice.h"
#include "evaluation/proposed_model.h"
#include "evaluation/robot_key.h"
#include "evaluation/target_simulator.h"
#include "evaluation/test_space.h"
#include "foundation/address.h"
#include "foundation/unit.h"
#include "storage/eea_records.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr double kMostSamples = 1e6;  // of a test; more would only show that memory ends

std::vector<FreeParameter> free_parameters(const ModelDefinition& model) {
  std::vector<FreeParameter> free;
  for (const FreeValue& value : model.free)
    free.push_back({value.address, value.unit, value.lower, value.upper, value.start, value.scale});
  return free;
}

/// What is wrong with the effects that a decoded model does without. Empty: nothing.
std::string misfit_of_effects(const std::vector<std::size_t>& without, const std::vector<ModelEffect>& effects) {
  for (std::size_t i = 0; i < without.size(); ++i) {
    if (without[i] >= effects.size())
      return "it left out effect " + std::to_string(without[i]) + " of a model that has " +
             std::to_string(effects.size());
    if (!effects[without[i]].optional)
      return "it left out the effect \"" + effects[without[i]].id + "\", which is not optional";
    if (i > 0 && without[i] <= without[i - 1]) return "the effects that it left out are not in ascending order";
  }
  return {};
}

/// What is wrong with a decoded model. Empty: nothing.
std::string misfit_of(const ModelProposal& decoded, const ModelSpace& space) {
  if (decoded.values.size() != space.free.size())
    return "it decoded " + std::to_string(decoded.values.size()) + " values instead of " +
           std::to_string(space.free.size());
  if (decoded.robot)
    if (const std::string problem = misfit(*decoded.robot, space.robot); !problem.empty())
      return "the robot that it built " + problem;
  return misfit_of_effects(decoded.without, space.effects);
}

/// Complains about actuators whose commands have no limits.
TestSpace limited_space(const Experiment& experiment, const RobotSpec& robot, Complaints& complaints) {
  TestSpace space = test_space(robot, experiment.engine, experiment.test.duration);
  for (std::size_t a = 0; a < space.actuators.size(); ++a)
    if (!std::isfinite(space.lower[a]) || !std::isfinite(space.upper[a]))
      complaints.add("test.encoding", "the commands of actuator \"" + space.actuators[a].name +
                                          "\" have no limits to make tests within; give it command_lower and "
                                          "command_upper, or a force_limit");
  return space;
}

std::vector<AppliedMutation> mutations_of(const std::vector<MutationEntry>& entries, const std::string& section,
                                          const PluginCatalog& catalog, Complaints& complaints) {
  std::vector<AppliedMutation> mutations;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string key = section + ".mutation[" + std::to_string(i) + "]";
    Chosen<MutationOperator> chosen =
        choose<MutationOperator>(catalog, entries[i].mutation, {key + ".operator", key + ".parameters"}, complaints);
    mutations.push_back({chosen.component, std::move(chosen.parameters), entries[i].chance, std::move(chosen.origin)});
  }
  return mutations;
}

/// The series from its start on for so many seconds.
TimeSeries until(TimeSeries series, double seconds) {
  constexpr double kRounding = 1e-9;  // s
  Eigen::Index rows = 0;
  while (rows < series.times.size() && series.times(rows) <= series.times(0) + seconds + kRounding) ++rows;
  series.times.conservativeResize(rows);
  series.samples.conservativeResize(rows, Eigen::NoChange);
  return series;
}

/// The layout that an encoding makes of its space, and the breeder of its genomes.
template <class Encoding, class Space>
std::unique_ptr<OperatorBreeder> breeder_for(const Chosen<Encoding>& encoding, const Space& space,
                                             const std::string& key, std::vector<AppliedMutation> mutations,
                                             Complaints& complaints) {
  try {
    GenomeLayout layout =
        guarded_call(encoding.origin, "layout", [&] { return encoding->layout(space, encoding.parameters); });
    const auto random = [encoding, layout](RandomStream& stream) {
      Genome genome = guarded_call(encoding.origin, "random", [&] { return encoding->random(layout, stream); });
      const std::string problem = misfit(genome, layout);
      if (!problem.empty())
        throw Error(to_string(encoding.origin) + ": its random genome " + problem + "; that is a fault of the plugin");
      return genome;
    };
    return std::make_unique<OperatorBreeder>(layout, random, std::move(mutations));
  } catch (const Error& error) {
    complaints.add(key, error.what());
    return nullptr;
  }
}

/// Operators that refuse the genomes, or their own parameters, are found before a run begins.
void try_operators(const OperatorBreeder& breeder, const std::string& section, Complaints& complaints) {
  for (std::size_t i = 0; i < breeder.mutations().size(); ++i) {
    if (!breeder.mutations()[i].mutation) continue;  // a complaint of its own
    try {
      RandomStream any(std::array<std::uint64_t, 1>{i});
      breeder.trial_child(i, any);
    } catch (const Error& error) {
      complaints.add(section + ".mutation[" + std::to_string(i) + "]", error.what());
    }
  }
}

/// And so are parameters that make no search. `section`: of the experiment.
void try_search(const SearchPlan& plan, const std::string& section, Complaints& complaints) {
  if (!plan.breeder) return;
  try_operators(*plan.breeder, section, complaints);
  const Chosen<SearchStrategy>& strategy = plan.strategy;
  if (!strategy.component) return;
  try {
    const SearchTask task{plan.layout(), *plan.breeder, {0}, {}};
    guarded_call(strategy.origin, "begin", [&] { return strategy->begin(task, strategy.parameters); });
  } catch (const Error& error) {
    complaints.add(section + ".parameters", error.what());
  }
}

}  // namespace

EeaDefinition::EeaDefinition(const Experiment& experiment, const PluginCatalog& catalog, ModelDefinition of_model,
                             bool takes_tests)
    : model(std::move(of_model)),
      compiled(compile(model.structure, model.engine)),
      model_space{model.structure.robot, free_parameters(model), model_effects(model)},
      gene_space(model_space),
      passes(takes_tests ? experiment.passes : 1),
      seeds(experiment.estimation.seeds),
      restarts(experiment.estimation.restarts),
      rivals(experiment.estimation.rivals),
      replay(experiment.estimation.replay),
      horizons(experiment.estimation.horizons),
      challenge(experiment.estimation.challenge),
      patience(experiment.estimation.patience),
      stop_below(experiment.exploration.stop_below),
      approximate(takes_tests && experiment.model.approximate),
      target_is_program(experiment.target.kind == "process"),
      abandon(experiment.estimation.abandon),
      reuse(experiment.estimation.reuse) {
  Complaints complaints(experiment);
  find_profiled(experiment.estimation, complaints);
  define_estimation(experiment, catalog, complaints);
  ensemble = static_cast<std::size_t>(experiment.estimation.ensemble);
  if (takes_tests) define_exploration(experiment, catalog, complaints);
  complaints.throw_if_any();
}

void EeaDefinition::define_estimation(const Experiment& experiment, const PluginCatalog& catalog,
                                      Complaints& complaints) {
  model_encoding = choose<ModelEncoding>(catalog, experiment.model.encoding,
                                         {"model.encoding", "model.encoding_parameters"}, complaints);
  const EstimationSection& estimate = experiment.estimation;
  metric = choose<FitnessMetric>(catalog, estimate.metric, {"estimation.metric", "estimation.metric_parameters"},
                                 complaints);
  if (!estimate.objective.empty())
    objective = choose<ObjectiveMetric>(catalog, {estimate.objective, {}},
                                        {"estimation.objective", "estimation.objective_parameters"}, complaints);
  estimation.strategy = choose<SearchStrategy>(catalog, estimate.search.search,
                                               {"estimation.search", "estimation.parameters"}, complaints);
  std::vector<AppliedMutation> mutations = mutations_of(estimate.search.mutation, "estimation", catalog, complaints);
  // Where the file leaves the encoding of values as it is, what is missing is something to encode.
  const bool only_free = gene_space.free.empty() && experiment.model.encoding.name == ModelSection{}.encoding.name;
  if (model_encoding.component)
    estimation.breeder = breeder_for(model_encoding, gene_space, only_free ? "model.free" : "model.encoding",
                                     std::move(mutations), complaints);
  try_search(estimation, "estimation", complaints);
  const std::vector<Channel> channels = sensor_channels(model.structure.robot);
  for (const std::size_t c : chosen_channels(model.structure.robot, estimate.sensors, "estimation.sensors", complaints))
    scored_channels.push_back(channels[c].name);
}

void EeaDefinition::define_exploration(const Experiment& experiment, const PluginCatalog& catalog,
                                       Complaints& complaints) {
  const ExplorationSection& explore = experiment.exploration;
  test_space = limited_space(experiment, model.structure.robot, complaints);
  seen_channels = chosen_channels(model.structure.robot, experiment.test.sensors, "test.sensors", complaints);
  if (!seen_channels.empty()) {
    std::vector<Channel> seen;
    for (const std::size_t c : seen_channels) seen.push_back(test_space.sensors[c]);
    test_space.sensors = std::move(seen);
  }
  const double samples = test_space.duration / test_space.control_period;
  if (samples <= kMostSamples)
    sample_times = lacuna::sample_times(model.engine, experiment.test.duration);
  else
    complaints.add("test.duration", "a test of " + format_quantity(test_space.duration, "s") +
                                        " has more than a million control periods of " +
                                        format_quantity(test_space.control_period, "s") +
                                        "; shorten it, or set engine.control_period");
  test_encoding =
      choose<TestEncoding>(catalog, experiment.test.encoding, {"test.encoding", "test.parameters"}, complaints);
  choose_fitnesses(explore, catalog, complaints);
  exploration.strategy = choose<SearchStrategy>(catalog, explore.search.search,
                                                {"exploration.search", "exploration.parameters"}, complaints);
  std::vector<AppliedMutation> of_tests = mutations_of(explore.search.mutation, "exploration", catalog, complaints);
  if (test_encoding.component)
    exploration.breeder = breeder_for(test_encoding, test_space, "test.encoding", std::move(of_tests), complaints);
  try_search(exploration, "exploration", complaints);
}

void EeaDefinition::choose_fitnesses(const ExplorationSection& explore, const PluginCatalog& catalog,
                                     Complaints& complaints) {
  std::vector<TestValue::Part> parts;
  parts.push_back({choose<TestFitness>(catalog, explore.fitness,
                                       {"exploration.fitness", "exploration.fitness_parameters"}, complaints),
                   1.0});
  for (std::size_t i = 0; i < explore.mix.size(); ++i) {
    const std::string key = "exploration.mix[" + std::to_string(i) + "]";
    parts.push_back(
        {choose<TestFitness>(catalog, explore.mix[i].fitness, {key + ".fitness", key + ".parameters"}, complaints),
         explore.mix[i].weight});
  }
  for (const TestValue::Part& part : parts)
    if (!part.fitness.component) return;  // a complaint of its own
  value = TestValue(std::move(parts));
  ensemble = std::max(ensemble, value.models());
}

/// Delays of sensors that are no genes.
void EeaDefinition::find_profiled(const EstimationSection& estimate, Complaints& complaints) {
  std::vector<bool> is_profiled(model_space.free.size(), false);
  for (std::size_t i = 0; i < estimate.profiled.size(); ++i) {
    const std::string key = "estimation.profiled[" + std::to_string(i) + "]";
    bool found = false;
    for (std::size_t v = 0; v < model_space.free.size(); ++v) {
      const FreeParameter& free = model_space.free[v];
      if (!matches(estimate.profiled[i], free.address)) continue;
      found = true;
      if (!matches("sensor.*.delay", free.address))
        complaints.add(key, free.address + " is no delay of a sensor; only those are found without simulating");
      else if (free.lower > 0.0)
        complaints.add(key, free.address + " begins at " + format_quantity(free.lower, "s") +
                                "; its range must begin at 0 s, for models are simulated without it");
      else
        is_profiled[v] = true;
    }
    if (!found) complaints.add(key, "no free value is called \"" + estimate.profiled[i] + "\"; see [model.free]");
  }
  if (!estimate.profiled.empty() && !estimate.replay)
    complaints.add("estimation.profiled",
                   "a controller answers to delayed readings, so delays change what a model does; write replay = true");
  gene_space.free.clear();
  for (std::size_t v = 0; v < model_space.free.size(); ++v)
    if (is_profiled[v])
      profiled.push_back(v);
    else
      gene_space.free.push_back(model_space.free[v]);
  for (ModelEffect& effect : gene_space.effects)  // whose parameters stand behind all values of the robot
    for (std::size_t& v : effect.values) v -= profiled.size();
}

ModelProposal EeaDefinition::decode_model(const Genome& genome) const {
  ModelProposal decoded = guarded_call(model_encoding.origin, "decode", [&] {
    return model_encoding->decode(gene_space, model_encoding.parameters, genome);
  });
  if (const std::string fault = misfit_of(decoded, gene_space); !fault.empty())
    throw Error(to_string(model_encoding.origin) + ": " + fault + "; that is a fault of the plugin: repair it");
  for (const std::size_t v : profiled)  // in ascending order, so that each stands at its place
    decoded.values.insert(decoded.values.begin() + static_cast<std::ptrdiff_t>(v), 0.0);
  for (const std::size_t effect : decoded.without)
    for (const std::size_t v : model_space.effects[effect].values) decoded.values[v] = kNotKnown;
  return decoded;
}

Test EeaDefinition::decode_test(const Genome& genome) const {
  Test test = guarded_call(test_encoding.origin, "decode",
                           [&] { return test_encoding->decode(test_space, test_encoding.parameters, genome); });
  return seen_channels.empty() ? test : with_view(std::move(test), seen_channels);
}

Test EeaDefinition::drive_of(Test test, const Trial& trial) const {
  if (target_is_program && std::holds_alternative<CommandSeries>(test.drive)) test.drive = trial.commands;
  return test;
}

ScoredTrial EeaDefinition::scored(Test drive, Trial trial, int pass) const {
  if (!scored_channels.empty()) trial = with_channels(std::move(trial), scored_channels);
  if (!horizons.empty()) {
    const auto last = static_cast<int>(horizons.size()) - 1;
    trial.measured =
        until(std::move(trial.measured), horizons[static_cast<std::size_t>(std::clamp(pass - 1, 0, last))]);
  }
  return observed(std::move(drive), std::move(trial));
}

ScoredTrial EeaDefinition::observed(Test drive, Trial trial) const {
  if (replay) drive.drive = trial.commands;
  return {std::move(drive), std::move(trial), 0};
}

}  // namespace lacuna
