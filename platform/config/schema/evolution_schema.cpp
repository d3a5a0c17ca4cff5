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
          "of that plugin, as `lacuna plugins show` lists them");
}

Table<MutationEntry> mutation_keys() {
  return Table<MutationEntry>()
      .required<std::string>(
          "operator", element_name(),
          [](MutationEntry& entry, std::string&& name) { entry.mutation.name = std::move(name); },
          "a mutation plugin's name")
      .key("chance", &MutationEntry::chance, number("1").between(0.0, 1.0), "that it is applied to a child")
      .key<Parameters>(
          "parameters", map_of("PARAMETER", number("")), {},
          [](MutationEntry& entry, Parameters&& read) { entry.mutation.parameters = std::move(read); },
          "of that plugin");
}

Table<MixEntry> mix_keys() {
  return Table<MixEntry>()
      .required<std::string>(
          "fitness", element_name(), [](MixEntry& entry, std::string&& name) { entry.fitness.name = std::move(name); },
          "a test fitness plugin's name")
      .key("weight", &MixEntry::weight, number("1"), "what its score is multiplied by before it is added")
      .key<Parameters>(
          "parameters", map_of("PARAMETER", number("")), {},
          [](MixEntry& entry, Parameters&& read) { entry.fitness.parameters = std::move(read); }, "of that plugin");
}

Table<SearchSection> search_keys() {
  return choice_keys<SearchSection>(
             Table<SearchSection>(), "search", "parameters",
             [](SearchSection& section) -> ComponentChoice& { return section.search; }, "a search plugin's name")
      .key("mutation", &SearchSection::mutation, list_of(mutation_keys().value()),
           "Operators that make a child, applied in this order; without it one_point_crossover on a quarter of the "
           "children, then uniform_reset on all.");
}

}  // namespace

Table<TestSection> test_keys() {
  return choice_keys<TestSection>(
             Table<TestSection>(), "encoding", "parameters",
             [](TestSection& section) -> ComponentChoice& { return section.encoding; },
             "what a test's genome means: a test encoding plugin")
      .key("duration", &TestSection::duration, number("s").above(0.0), "how long a test lasts")
      .key("sensors", &TestSection::sensors, list_of(text()),
           "what a controller sees, as in \"sensor.angle*\"; without it all sensors of the robot");
}

Table<EstimationSection> estimation_keys() {
  return choice_keys<EstimationSection>(
             Table<EstimationSection>().merged(&EstimationSection::search, search_keys()), "metric",
             "metric_parameters", [](EstimationSection& section) -> ComponentChoice& { return section.metric; },
             "the metric by which models are judged: a metric plugin's name")
      .key("objective", &EstimationSection::objective, text(0),
           "an objective metric's name: how far the best model is from the hidden truth, after each pass; nothing in "
           "the search sees it")
      .key("sensors", &EstimationSection::sensors, list_of(text()),
           "what models are scored by, as in \"sensor.range*\"; without it all sensors that are measured")
      .key("seeds", &EstimationSection::seeds, whole_number<int>(0, 1000000),
           "how many of the last pass's best models start the next one, beside random ones; of several "
           "restarts the first alone, of rivals each")
      .key("restarts", &EstimationSection::restarts, whole_number<int>(1, 10000),
           "independent searches in each phase, each as long as one; the best of each are handed on first")
      .key("rivals", &EstimationSection::rivals, boolean(),
           "each restart looks for the best model of another structure (another set of effects, another tree of parts) "
           "than those that the restarts before it ended with")
      .key("ensemble", &EstimationSection::ensemble, whole_number<int>(1, 10000),
           "how many models that differ are kept of each pass, the best of each structure and restart first; those "
           "that judge tests are kept in any case")
      .key("replay", &EstimationSection::replay, boolean(),
           "drive models by the commands that the target received, not by the test's controller, which would answer to "
           "the model's own readings")
      .key("horizons", &EstimationSection::horizons, list_of<double>(number("s").above(0.0)),
           "how much of each trial counts, from its start: in the first pass, the second and so on, each at least as "
           "long as the one before, the last for all that follow; without it all of it")
      .key("profiled", &EstimationSection::profiled, list_of(text()),
           "free delays, as in \"sensor.*.delay\", that are no genes but found for each model by shifting what it "
           "reads, at no further simulation; in the end those of all sensors over whole trials; between two readings "
           "it goes along a straight line, so "
           "that a sensor that jumps wants a reading at every step; takes replay = true")
      .key("challenge", &EstimationSection::challenge, number("1").at_least(0.0),
           "a new trial on which the best model errs more than this many times as much as on those it was fitted to is "
           "set aside, and counts again once models come near enough, after three passes at the latest; never the "
           "first two trials, nor where the error is below a hundredth of that of standing still; 0: none is")
      .key("patience", &EstimationSection::patience, whole_number<int>(0, 1000000),
           "the run stops, before it looks for another test, after this many passes in which models have not foretold "
           "a new trial any better; 0: it does not")
      .key("abandon", &EstimationSection::abandon, boolean(),
           "end an evaluation as soon as its error cannot get under the generation's bar; changes no survivor")
      .key("reuse", &EstimationSection::reuse, boolean(), "simulate identical models once; changes no score");
}

Table<ExplorationSection> exploration_keys() {
  return choice_keys<ExplorationSection>(
             Table<ExplorationSection>().merged(&ExplorationSection::search, search_keys()), "fitness",
             "fitness_parameters", [](ExplorationSection& section) -> ComponentChoice& { return section.fitness; },
             "what makes a test good: a test fitness plugin's name")
      .key("mix", &ExplorationSection::mix, list_of(mix_keys().value()),
           "Further fitnesses, each added with its weight, such as a behaviour that is wanted beside disagreement.")
      .key<double>(
          "stop_below", number("1"), std::numeric_limits<double>::quiet_NaN(),
          [](ExplorationSection& section, double&& read) { section.stop_below = read; },
          "a bare number in the fitness's unit: the run stops where no test is worth more; without it it does not");
}

}  // namespace lacuna
