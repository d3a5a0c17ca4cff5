#include "answer/stopped_search.h"

#include "candidates/hypothesis.h"
#include "foundation/text/counted.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <utility>

namespace lacuna {
namespace {

std::string what_to_do(std::size_t kept_models) {
  if (kept_models > 0)
    return fmt::format("Run the same command again: it continues after {} that this call has finished.",
                       counted(kept_models, "model"));
  return "Run the command again with a longer --time-limit, or without one.";
}

}  // namespace

std::vector<std::string> candidate_names(const Experiment& experiment, const PluginCatalog& catalog,
                                         const ModelDefinition& definition, const std::vector<std::string>& among) {
  std::vector<std::string> names;
  std::vector<Untestable> untestable;
  for (const Hypothesis& one : list_hypotheses(experiment, catalog, definition, among, untestable))
    names.push_back(member_name(one.entry));
  return names;
}

void mark_stopped(StoppedSearch stop, const Stop& work, std::size_t kept_models, Diagnosis& diagnosis) {
  diagnosis.probability = std::numeric_limits<double>::quiet_NaN();
  diagnosis.calibrated = false;
  stop.next = what_to_do(kept_models);
  std::vector<std::string> sentences = {
      fmt::format("The search was {}, during: {}.", work.reason_of_limit(), stop.during),
      diagnosis.ranking.empty()
          ? "No candidate was examined."
          : "The verdict is preliminary: it covers the candidates examined so far and states no probability."};
  if (!stop.not_examined.empty())
    sentences.push_back(fmt::format("Not examined: {}.", fmt::join(stop.not_examined, ", ")));
  sentences.push_back(stop.next);
  diagnosis.findings.insert(diagnosis.findings.begin(), sentences.begin(), sentences.end());
  diagnosis.stopped = std::move(stop);
}

Diagnosis stopped_before_search(const Experiment& experiment, const PluginCatalog& catalog,
                                const ModelDefinition& definition, const std::vector<std::string>& among,
                                std::string during, const Stop& work) {
  Diagnosis nothing;
  mark_stopped({std::move(during), candidate_names(experiment, catalog, definition, among), {}}, work, 0, nothing);
  return nothing;
}

}  // namespace lacuna
