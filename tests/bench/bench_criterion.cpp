#include "app/workspace/rig.h"
#include "effect_search/effect_search.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// What is missing from models, by the criterion of whitened predictions.
///
///   bench_criterion EXPERIMENT.toml ...                    a line of JSON each, with all sets that were fitted
///   bench_criterion diagnose EXPERIMENT.toml --json=FILE   what `lacuna diagnose` would write, for lacuna-benchmark
///
/// With LACUNA_NOTES set, every fit is noted on standard error.
namespace lacuna {
namespace {

using nlohmann::json;

double processor_seconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

SearchResult search(const std::string& file) {
  const double begin = processor_seconds();
  CommonOptions options;
  options.experiment = file;
  const Rig rig = open_rig(options);
  MissingTask task{rig.experiment, *rig.catalog, rig.trials, rig.definition.start_values()};
  if (std::getenv("LACUNA_NOTES") != nullptr)
    task.note = [&](const std::string& what) {
      fmt::print(stderr, "{:.1f} s {}\n", processor_seconds() - begin, what);
    };
  return search_effects(task);
}

/// Mean squares of whitened residuals by cell.
std::vector<double> means_of(const SearchResult& found, const FittedModel& set) {
  const Eigen::VectorXd means =
      cost_at(found.layout, set.fit.products, Eigen::VectorXd::Zero(set.fit.products.values())).mean_square;
  return {means.begin(), means.end()};
}

json rows_of(const Eigen::MatrixXd& matrix) {
  json rows = json::array();
  for (const auto row : matrix.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

json every_set(const SearchResult& found) {
  json result;
  const Decision& decision = found.decision;
  const FittedModel& answer = found.sets[decision.answer];
  result["answer"] = answer.judged.members;
  result["values"] = answer.values;
  result["alike"] = json::array();
  for (const std::size_t i : decision.alike) result["alike"].push_back(found.sets[i].judged.members);
  result["p"] = decision.p;
  result["gain"] = {decision.gain.nats, decision.gain.error};
  result["whole"] = decision.whole_gain;
  result["all_lengths"] = found.by_all_lengths;
  result["lengths"] = found.lengths;
  result["fits"] = found.fits;
  for (const FittedModel& set : found.sets) {
    const CostGain gain = gain_of(set.judged, found.sets.front().judged);
    result["sets"].push_back({{"members", set.judged.members},
                              {"told", set.judged.told},
                              {"fitted", found.sets.front().fit.cost - set.fit.cost},
                              {"means", means_of(found, set)},
                              {"values", set.values},
                              {"by_length", rows_of(set.judged.cost.by_length)},
                              {"gain", {gain.nats, gain.error}}});
  }
  return result;
}

json effect_of(const FittedModel& set, const EffectEntry& entry) {
  json parameters = json::object();
  const std::string prefix = member_name(entry) + ".";
  for (const auto& [name, value] : set.values)
    if (name.starts_with(prefix))
      parameters[name.substr(prefix.size())] = {{"value", value}, {"ci95", {nullptr, nullptr}}};
  return {{"effect", entry.effect},
          {"where", entry.where.empty() ? "" : entry.where.front()},
          {"parameters", std::move(parameters)}};
}

json as_diagnosis(const SearchResult& found) {
  const Decision& decision = found.decision;
  const FittedModel& answer = found.sets[decision.answer];
  json model = {{"gain", decision.gain.nats}, {"effects", json::array()}, {"class", json::array()}};
  for (const EffectEntry& entry : answer.model.added) model["effects"].push_back(effect_of(answer, entry));
  std::set<std::string> alike;
  for (const std::size_t i : decision.alike)
    for (const std::string& member : found.sets[i].judged.members)
      if (!answer.judged.members.contains(member)) alike.insert(member);
  model["class"] = alike;
  json result = {{"verdict", decision.answer == 0 ? "nothing_missing" : "effect_found"},
                 {"probability", nullptr},
                 {"p_by_chance", decision.p},
                 {"ranking", json::array()},
                 {"values", json::object()}};
  if (decision.answer != 0) result["ranking"].push_back(std::move(model));
  return result;
}

int diagnose(const std::vector<std::string>& words) {
  constexpr std::string_view kFile = "--json=";
  const double begin = processor_seconds();
  json result = as_diagnosis(search(words.at(1)));
  result["seconds"] = processor_seconds() - begin;
  for (const std::string& word : words)
    if (word.starts_with(kFile)) std::ofstream(word.substr(kFile.size())) << result.dump(1) << '\n';
  return EXIT_SUCCESS;
}

int print_sets(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    json result;
    const double begin = processor_seconds();
    try {
      result = every_set(search(file));
    } catch (const std::exception& error) {
      result["failure"] = error.what();
    }
    result["file"] = file;
    result["seconds"] = processor_seconds() - begin;
    fmt::print("{}\n", result.dump());
    std::fflush(stdout);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (!words.empty() && words[0] == "--version") return fmt::print("0.1\n"), EXIT_SUCCESS;
    return !words.empty() && words[0] == "diagnose" ? lacuna::diagnose(words) : lacuna::print_sets(words);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return EXIT_FAILURE;
  }
}
