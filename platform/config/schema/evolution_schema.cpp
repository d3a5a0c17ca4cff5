#include "config/schema/experiment_schema.h"

#include <limits>

namespace lacuna {
namespace {

using Parameters = std::map<std::string, double>;

/// Two keys that choose a component: its name, and values for its parameters.
template <class T>
Table<T> choice_keys(Table<T> table, const std::string& name_key, const std::string& parameters_key,
                     std::function<ComponentChoice&(T&)> choice, const std::string& description) {
  T fresh;
  return table
      .template key<std::string>(
          name_key, element_name(), choice(fresh).name,
          [choice](T& object, std::string&& name) { choice(object).name = std::move(name); }, description)
      .template key<Parameters>(
          parameters_key, map_of("PARAMETER", number("")), {},
          [choice](T& object, Parameters&& read) { choice(object).parameters = std::move(read); },
          "parameters of this plugin; `lacuna plugins show` lists them");
}

Table<MutationEntry> mutation_keys() {
  return Table<MutationEntry>()
      .required<std::string>(
          "operator", element_name(),
          [](MutationEntry& entry, std::string&& name) { entry.mutation.name = std::move(name); },
          "name of a mutation plugin")
      .key("chance", &MutationEntry::chance, number("1").between(0.0, 1.0), "probability that it is applied to a child")
      .key<Parameters>(
          "parameters", map_of("PARAMETER", number("")), {},
          [](MutationEntry& entry, Parameters&& read) { entry.mutation.parameters = std::move(read); },
          "parameters of this plugin");
}

Table<MixEntry> mix_keys() {
  return Table<MixEntry>()
      .required<std::string>(
          "fitness", element_name(), [](MixEntry& entry, std::string&& name) { entry.fitness.name = std::move(name); },
          "name of a test fitness plugin")
      .key("weight", &MixEntry::weight, number("1"), "factor of its score in the sum")
      .key<Parameters>(
          "parameters", map_of("PARAMETER", number("")), {},
          [](MixEntry& entry, Parameters&& read) { entry.fitness.parameters = std::move(read); },
          "parameters of this plugin");
}

Table<SearchSection> search_keys() {
  return choice_keys<SearchSection>(
             Table<SearchSection>(), "search", "parameters",
             [](SearchSection& section) -> ComponentChoice& { return section.search; }, "name of a search plugin")
      .key("mutation", &SearchSection::mutation, list_of(mutation_keys().value()),
           "Operators that make a child, in this order; default: one_point_crossover for a quarter of the children, "
           "then uniform_reset for all.");
}

}  // namespace

Table<TestSection> test_keys() {
  return choice_keys<TestSection>(
             Table<TestSection>(), "encoding", "parameters",
             [](TestSection& section) -> ComponentChoice& { return section.encoding; },
             "name of the test encoding plugin, which decodes genomes into tests")
      .key("duration", &TestSection::duration, number("s").above(0.0), "duration of a test")
      .key("sensors", &TestSection::sensors, list_of(text()),
           "sensors that a controller reads, as in \"sensor.angle*\"; default: all sensors of the robot");
}

Table<EstimationSection> estimation_keys() {
  return choice_keys<EstimationSection>(
             Table<EstimationSection>().merged(&EstimationSection::search, search_keys()), "metric",
             "metric_parameters", [](EstimationSection& section) -> ComponentChoice& { return section.metric; },
             "name of the metric plugin that scores models")
      .key("objective", &EstimationSection::objective, text(0),
           "name of an objective metric: distance of the best model from the hidden values after each pass; no search "
           "uses it")
      .key("sensors", &EstimationSection::sensors, list_of(text()),
           "sensors on which models are scored, as in \"sensor.range*\"; default: all measured sensors")
      .key("seeds", &EstimationSection::seeds, whole_number<int>(0, 1000000),
           "number of best models of the last pass that start the next pass, beside random ones; with several restarts "
           "only in the first, with rivals in each")
      .key("restarts", &EstimationSection::restarts, whole_number<int>(1, 10000),
           "number of independent searches in each phase, each of full length; the best models of each are carried "
           "over first")
      .key("rivals", &EstimationSection::rivals, boolean(),
           "each restart searches for a model of another structure (another set of effects, another tree of parts) "
           "than the earlier restarts found")
      .key("ensemble", &EstimationSection::ensemble, whole_number<int>(1, 10000),
           "number of different models stored per pass, the best of each structure and restart first; models that "
           "judge tests are always stored")
      .key("replay", &EstimationSection::replay, boolean(),
           "drive models with the commands that the target received, not with the test's controller, which would react "
           "to the model's readings")
      .key("horizons", &EstimationSection::horizons, list_of<double>(number("s").above(0.0)),
           "part of each trial that counts, from its start: one duration per pass, not decreasing, the last one for "
           "all later passes; default: the whole trial")
      .key("profiled", &EstimationSection::profiled, list_of(text()),
           "free delays, as in \"sensor.*.delay\", that are not genes: they are found for each model by shifting its "
           "readings, without further simulation; at the end for all sensors over whole trials; readings are "
           "interpolated linearly, so a sensor that jumps needs a reading at every step; needs replay = true")
      .key("challenge", &EstimationSection::challenge, number("1").at_least(0.0),
           "a new trial is set aside if the best model's error on it exceeds this factor times its error on the fitted "
           "trials; it counts again when models come close enough, after three passes at the latest; never the "
           "first two trials, nor trials with an error below a hundredth of that of a robot at rest; 0: no trial is "
           "set aside")
      .key("patience", &EstimationSection::patience, whole_number<int>(0, 1000000),
           "the run stops after this number of passes without a smaller prediction error on new trials; 0: never")
      .key("abandon", &EstimationSection::abandon, boolean(),
           "end an evaluation as soon as its error exceeds the generation's bar; changes no survivor")
      .key("reuse", &EstimationSection::reuse, boolean(), "simulate identical models only once; changes no score");
}

Table<ExplorationSection> exploration_keys() {
  return choice_keys<ExplorationSection>(
             Table<ExplorationSection>().merged(&ExplorationSection::search, search_keys()), "fitness",
             "fitness_parameters", [](ExplorationSection& section) -> ComponentChoice& { return section.fitness; },
             "name of the test fitness plugin, which scores tests")
      .key("mix", &ExplorationSection::mix, list_of(mix_keys().value()),
           "Further test fitnesses, added with their weights, such as a wanted behaviour beside disagreement.")
      .key<double>(
          "stop_below", number("1"), std::numeric_limits<double>::quiet_NaN(),
          [](ExplorationSection& section, double&& read) { section.stop_below = read; },
          "a plain number in the unit of the fitness: the run stops if no test exceeds it; default: never");
}

}  // namespace lacuna
