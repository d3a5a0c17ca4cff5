#include "app/workspace/rig.h"
#include "search/effect_search.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

/// All sets of effects that the search for what is missing fits, a line of JSON an experiment:
///
///   bench_criterion EXPERIMENT.toml ...
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
  EffectSearchTask task{rig.experiment, *rig.catalog, rig.trials, rig.definition.start_values()};
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
  result["lengths"] = found.data->ladder().lengths;
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

int main(int argc, char** argv) { return lacuna::print_sets({argv + 1, argv + argc}); }
