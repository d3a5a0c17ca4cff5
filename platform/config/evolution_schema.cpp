#include "config/experiment_schema.h"

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
           "how many of the last pass's best models start the next one, beside random ones")
      .key("abandon", &EstimationSection::abandon, boolean(),
           "end an evaluation as soon as its error cannot get under the generation's bar; changes no survivor")
      .key("reuse", &EstimationSection::reuse, boolean(), "simulate identical models once; changes no score");
}

Table<ExplorationSection> exploration_keys() {
  return choice_keys<ExplorationSection>(
      Table<ExplorationSection>().merged(&ExplorationSection::search, search_keys()), "fitness", "fitness_parameters",
      [](ExplorationSection& section) -> ComponentChoice& { return section.fitness; },
      "what makes a test good: a test fitness plugin's name");
}

}  // namespace lacuna
