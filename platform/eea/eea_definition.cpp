#include "eea/eea_definition.h"

#include "evaluation/target_simulator.h"
#include "evaluation/test_space.h"
#include "foundation/unit.h"

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

/// Parameters that make no search are found before a run begins.
void try_search(const SearchPlan& plan, const std::string& key, Complaints& complaints) {
  const Chosen<SearchStrategy>& strategy = plan.strategy;
  if (!strategy.component || !plan.breeder) return;
  try {
    const SearchTask task{plan.layout(), *plan.breeder, {0}, {}};
    guarded_call(strategy.origin, "begin", [&] { return strategy->begin(task, strategy.parameters); });
  } catch (const Error& error) {
    complaints.add(key, error.what());
  }
}

}  // namespace

EeaDefinition::EeaDefinition(const Experiment& experiment, const PluginCatalog& catalog, ModelDefinition of_model,
                             bool takes_tests)
    : model(std::move(of_model)),
      compiled(compile(model.structure, model.engine)),
      model_space{model.structure.robot, free_parameters(model)},
      passes(takes_tests ? experiment.passes : 1),
      seeds(experiment.estimation.seeds),
      approximate(takes_tests && experiment.model.approximate),
      abandon(experiment.estimation.abandon),
      reuse(experiment.estimation.reuse) {
  Complaints complaints(experiment);
  if (model.free.empty())
    complaints.add("model.free", "is empty: there is nothing to estimate; name at least one value with its bounds");
  define_estimation(experiment, catalog, complaints);
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
  if (model_encoding.component && !model.free.empty())
    estimation.breeder = breeder_for(model_encoding, model_space, "model.encoding", std::move(mutations), complaints);
  try_search(estimation, "estimation.parameters", complaints);
}

void EeaDefinition::define_exploration(const Experiment& experiment, const PluginCatalog& catalog,
                                       Complaints& complaints) {
  const ExplorationSection& explore = experiment.exploration;
  test_space = limited_space(experiment, model.structure.robot, complaints);
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
  fitness = choose<TestFitness>(catalog, explore.fitness, {"exploration.fitness", "exploration.fitness_parameters"},
                                complaints);
  exploration.strategy = choose<SearchStrategy>(catalog, explore.search.search,
                                                {"exploration.search", "exploration.parameters"}, complaints);
  std::vector<AppliedMutation> of_tests = mutations_of(explore.search.mutation, "exploration", catalog, complaints);
  if (test_encoding.component)
    exploration.breeder = breeder_for(test_encoding, test_space, "test.encoding", std::move(of_tests), complaints);
  try_search(exploration, "exploration.parameters", complaints);
  if (fitness.component)
    models_for_tests = guarded_call(fitness.origin, "models", [&] { return fitness->models(fitness.parameters); });
}

std::vector<double> EeaDefinition::decode_model(const Genome& genome) const {
  std::vector<double> values = guarded_call(model_encoding.origin, "decode", [&] {
    return model_encoding->decode(model_space, model_encoding.parameters, genome).values;
  });
  if (values.size() == model.free.size()) return values;
  throw Error(to_string(model_encoding.origin) + ": it decoded " + std::to_string(values.size()) +
              " values instead of " + std::to_string(model.free.size()) + "; that is a fault of the plugin: repair it");
}

Test EeaDefinition::decode_test(const Genome& genome) const {
  return guarded_call(test_encoding.origin, "decode",
                      [&] { return test_encoding->decode(test_space, test_encoding.parameters, genome); });
}

}  // namespace lacuna
