#include "eea/definition/eea_definition.h"

#include "evaluation/model/channel_choice.h"
#include "evaluation/prediction/target_simulator.h"
#include "evaluation/prediction/test_space.h"
#include "foundation/address.h"
#include "foundation/unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

/// Finds and checks the plugins that an experiment names.
namespace lacuna {
namespace {

constexpr double kMostSamples = 1e6;    // of a test; a longer one needs too much memory
constexpr double kUnitRounding = 1e-9;  // between two values that were written in different units

/// Complains about actuators whose commands have no limits.
TestSpace limited_space(const Experiment& experiment, const RobotSpec& robot, Complaints& complaints) {
  TestSpace space = test_space(robot, experiment.engine, experiment.test.duration);
  for (std::size_t a = 0; a < space.actuators.size(); ++a)
    if (!std::isfinite(space.lower[a]) || !std::isfinite(space.upper[a]))
      complaints.add(
          "test.encoding",
          "the commands of actuator \"" + space.actuators[a].name +
              "\" have no limits, so no tests can be made; give it command_lower and command_upper, or a force_limit");
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

/// The layout that an encoding makes for its space, and the breeder of its genomes.
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
        throw Error(to_string(encoding.origin) + ": its random genome " + problem + "; this is a fault of the plugin");
      return genome;
    };
    return std::make_unique<OperatorBreeder>(layout, random, std::move(mutations));
  } catch (const Error& error) {
    complaints.add(key, error);
    return nullptr;
  }
}

/// Finds operators that refuse the genomes or their own parameters before a run begins.
void try_operators(const OperatorBreeder& breeder, const std::string& section, Complaints& complaints) {
  for (std::size_t i = 0; i < breeder.mutations().size(); ++i) {
    if (!breeder.mutations()[i].mutation) continue;  // the plugin's own complaint
    try {
      RandomStream any(std::array<std::uint64_t, 1>{i});
      breeder.trial_child(i, any);
    } catch (const Error& error) {
      complaints.add(section + ".mutation[" + std::to_string(i) + "]", error);
    }
  }
}

/// The same for parameters of a search. `section`: of the experiment.
void try_search(const SearchPlan& plan, const std::string& section, Complaints& complaints) {
  if (!plan.breeder) return;
  try_operators(*plan.breeder, section, complaints);
  const Chosen<SearchStrategy>& strategy = plan.strategy;
  if (!strategy.component) return;
  try {
    const SearchTask task{plan.layout(), *plan.breeder, {0}, {}};
    guarded_call(strategy.origin, "begin", [&] { return strategy->begin(task, strategy.parameters); });
  } catch (const Error& error) {
    complaints.add(section + ".parameters", error);
  }
}

}  // namespace

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
  // Where the file does not choose an encoding, the problem is that there is nothing to encode.
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
  if (samples + kUnitRounding < 1.0)
    complaints.add("test.duration", "a test of " + format_quantity(test_space.duration, "s") +
                                        " is shorter than one control period of " +
                                        format_quantity(test_space.control_period, "s") +
                                        ", so nothing moves in it; make it longer or engine.step smaller");
  else if (samples <= kMostSamples)
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

namespace {

/// Whether a fitness accepts its parameters.
bool try_fitness(const TestValue::Part& part, const std::string& key, Complaints& complaints) {
  try {
    const TestValue alone({part});
    return true;
  } catch (const BadInput&) {
    throw;
  } catch (const Error& error) {
    complaints.add(key, error);
    return false;
  }
}

}  // namespace

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
  bool usable = true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string key =
        i == 0 ? "exploration.fitness_parameters" : "exploration.mix[" + std::to_string(i - 1) + "].parameters";
    usable = parts[i].fitness.component && try_fitness(parts[i], key, complaints) &&
             usable;  // or the plugin's own complaint
  }
  if (!usable) return;
  value = TestValue(std::move(parts));
  if (value.models() == 0 && explore.stop_below)
    complaints.add("exploration.stop_below",
                   "stop_below has no meaning for " + value.name() +
                       ", which gives all tests the same worth; leave stop_below out, or choose another fitness");
  ensemble = std::max(ensemble, value.models());
}

}  // namespace lacuna
