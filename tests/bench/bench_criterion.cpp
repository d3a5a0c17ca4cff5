#include "answer/fitted_values.h"
#include "answer/search_findings.h"
#include "app/workspace/open_experiment.h"
#include "foundation/processes/interrupt.h"
#include "search/effect_search.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <vector>

/// All sets of effects that the search for what is missing fits, a line of JSON an experiment:
///
///   bench_criterion EXPERIMENT.toml ...
///
/// With LACUNA_NOTES set, every fit is noted on standard error; LACUNA_SECONDS ends each search.
namespace lacuna {
namespace {

using nlohmann::json;

double processor_seconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

json rows_of(const Eigen::MatrixXd& matrix) {
  json rows = json::array();
  for (const auto row : matrix.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

/// What was looked at beside each set, gains over it by block.
json looked_at(const SearchResult& found) {
  json all = json::array();
  for (const LookedBeside& beside : found.looked) {
    json gains = json::array();
    for (const Eigen::VectorXd& gain : beside.gains) {
      json row = json::array();
      for (const double nats : gain) row.push_back(json::parse(fmt::format("{:.4g}", nats)));
      gains.push_back(std::move(row));
    }
    all.push_back({{"members", beside.members}, {"gains", std::move(gains)}});
  }
  return all;
}

/// [lower, value, upper] of the members' values; null where the data tell no interval.
json intervals_of(const SearchResult& found, const FittedModel& set) {
  json all;
  for (const FoundEffect& effect : FittedValues(found, set).effects())
    for (const FoundParameter& one : effect.parameters)
      all[effect.effect + " @ " + effect.where + "." + one.name] = {one.lower_95, one.value, one.upper_95};
  return all;
}

json every_set(const SearchResult& found) {
  json result;
  result["verdict"] = to_string(findings_of(found).verdict);
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
  result["lengths"] = found.data->ladder().lengths;
  result["fits"] = found.fits;
  result["nested"] = {found.nested, found.unnested};
  result["stopped"] = found.stopped;
  result["looked"] = looked_at(found);
  for (const FittedModel& set : found.sets) {
    const CostGain gain = gain_of(set.judged, found.sets.front().judged);
    result["sets"].push_back(
        {{"members", set.judged.members},
         {"told", set.judged.told},
         {"count", set.judged.values},
         {"fitted", found.sets.front().fit.cost - set.fit.cost},
         {"means", std::vector<double>(set.judged.mean_square.begin(), set.judged.mean_square.end())},
         {"values", set.values},
         {"intervals", intervals_of(found, set)},
         {"by_length", rows_of(set.judged.cost.by_length)},
         {"gain", {gain.nats, gain.error}}});
  }
  return result;
}

json search(const std::string& file, const Stop& stop) {
  const double begin = processor_seconds();
  CommonOptions options;
  options.experiment = file;
  const OpenExperiment opened = open_experiment(options);
  EffectSearchTask task{opened.experiment, *opened.catalog, opened.trials, opened.definition.start_values()};
  task.work.stop = stop;
  if (std::getenv("LACUNA_NOTES") != nullptr)
    task.note = [&](const std::string& what) {
      fmt::print(stderr, "{:.1f} s {}\n", processor_seconds() - begin, what);
    };
  return every_set(search_effects(task));
}

int print_sets(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    json result;
    const double begin = processor_seconds();
    std::optional<TimeLimit> limit;
    if (const char* seconds = std::getenv("LACUNA_SECONDS")) limit.emplace(std::atof(seconds), seconds);
    try {
      result = search(file, limit ? when_interrupted().within(*limit) : when_interrupted());
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

int main(int argc, char** argv) { return lacuna::print_sets({argv + 1, argv + argc}); }
