#include "storage/traces/named_trace.h"

#include "foundation/text/problem.h"
#include "storage/core/statement.h"
#include "storage/traces/read_trace.h"
#include "storage/traces/write_trial.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

namespace lacuna {
namespace {

constexpr const char* kMeasured = "measured";
constexpr const char* kPredicted = "predicted";

struct FoundTrial {
  TrialId id;
  std::string experiment, name;
};

/// A trace, and of one that a model predicted whose model it was.
struct FoundTrace {
  TraceId id;
  std::optional<int> revision;
  bool as_written = false;  ///< by values as they were written, not fitted
};

/// The newest first. A trial that was read anew, since its file or its columns have changed, has several rows.
std::vector<FoundTrial> trials_of(const Database& database, const std::string& name) {
  Statement row(database,
                "SELECT trial.id, experiment.name, trial.name FROM trial"
                " JOIN experiment ON experiment.id = trial.experiment"
                " WHERE (trial.name = ?1 OR trial.file = ?1) AND EXISTS (SELECT 1 FROM trace WHERE trial = trial.id)"
                " ORDER BY trial.id DESC");
  row.with(name);
  std::vector<FoundTrial> trials;
  while (row.step()) trials.push_back({{row.integer(0)}, row.text(1), row.text(2)});
  return trials;
}

/// Several trials of one name may only be the same one at different times.
void refuse_several(const Database& database, const std::string& name, const std::vector<FoundTrial>& trials) {
  std::vector<std::string> different;
  for (const FoundTrial& one : trials) {
    const std::string both = fmt::format("{} of {}", one.name, one.experiment);
    if (std::find(different.begin(), different.end(), both) == different.end()) different.push_back(both);
  }
  if (different.size() < 2) return;
  throw_problem(
      {database.file().string()},
      fmt::format(
          "\"{}\" names several trials ({}); give the number of the prediction instead (column id of the view traces)",
          name, nearest_names(name, different)));
}

/// The newest prediction by a fitted model comes before those by values as they were written.
std::optional<FoundTrace> newest_prediction(const Database& database, TrialId trial, std::optional<int> revision) {
  Statement row(database,
                "SELECT trace.id, revision.number, comparison.kind IS 'as_written'"
                " FROM trace LEFT JOIN comparison ON comparison.id = trace.comparison"
                " LEFT JOIN revision ON revision.id = comparison.revision"
                " WHERE trace.trial = ?1 AND trace.kind = 'predicted' AND (?2 IS NULL OR revision.number = ?2)"
                " ORDER BY comparison.kind IS 'as_written', trace.id DESC LIMIT 1");
  if (!row.with(trial, revision).step()) return std::nullopt;
  return FoundTrace{{row.integer(0)}, row.optional_number(1), row.integer(2) != 0};
}

/// Of all readings of a trial; also which of them it is of.
struct TrialPrediction {
  const FoundTrial* trial = nullptr;
  FoundTrace trace;
};

std::optional<TrialPrediction> newest_prediction(const Database& database, const std::vector<FoundTrial>& trials,
                                                 std::optional<int> revision) {
  const auto order = [](const FoundTrace& trace) { return std::pair(!trace.as_written, trace.id.value); };
  std::optional<TrialPrediction> newest;
  for (const FoundTrial& trial : trials)
    if (const auto found = newest_prediction(database, trial.id, revision);
        found && (!newest || order(*found) > order(newest->trace)))
      newest = {&trial, *found};
  return newest;
}

[[noreturn]] void refuse_revision(const Database& database, const std::vector<FoundTrial>& trials, int revision) {
  std::set<int> others;
  for (const FoundTrial& trial : trials) {
    Statement row(database,
                  "SELECT DISTINCT revision.number FROM trace JOIN comparison ON comparison.id = trace.comparison"
                  " JOIN revision ON revision.id = comparison.revision WHERE trace.trial = ?");
    row.with(trial.id);
    while (row.step()) others.insert(row.number(0));
  }
  throw_problem(
      {database.file().string()},
      fmt::format("--revision {}: this revision has no prediction of {}; {}", revision, trials.front().name,
                  others.empty() ? "to make one: lacuna compare"
                                 : fmt::format("there are predictions of revision {}", fmt::join(others, ", "))));
}

std::optional<NamedTrace> by_name(const Database& database, const TraceQuestion& question) {
  const std::vector<FoundTrial> trials = trials_of(database, question.name);
  if (trials.empty()) return std::nullopt;
  refuse_several(database, question.name, trials);
  const std::optional<TrialPrediction> prediction = newest_prediction(database, trials, question.revision);
  if (!prediction && question.revision) refuse_revision(database, trials, *question.revision);
  const FoundTrial& trial = prediction ? *prediction->trial : trials.front();
  NamedTrace found{trial.experiment, trial.name, prediction ? prediction->trace.revision : std::nullopt, {}};
  if (const auto measured = find_trace(database, {.trial = trial.id, .kind = TraceKind::measured}))
    found.parts.push_back({kMeasured, read_trace(database, *measured)});
  if (prediction) found.parts.push_back({kPredicted, read_trace(database, prediction->trace.id)});
  return found;
}

std::string label_of(const std::string& kind) {
  if (kind == "commands") return "commanded";
  return kind == "centre_of_mass" ? "centre of mass" : kind;
}

std::optional<NamedTrace> by_number(const Database& database, TraceId trace) {
  Statement row(database,
                "SELECT trial.id, experiment.name, trial.name, trace.kind, revision.number FROM trace"
                " JOIN trial ON trial.id = trace.trial JOIN experiment ON experiment.id = trial.experiment"
                " LEFT JOIN comparison ON comparison.id = trace.comparison"
                " LEFT JOIN revision ON revision.id = comparison.revision WHERE trace.id = ?");
  if (!row.with(trace).step()) return std::nullopt;
  NamedTrace found{row.text(1), row.text(2), row.optional_number(4), {}};
  const TrialId trial{row.integer(0)};
  const std::string kind = row.text(3);
  if (kind == kPredicted)
    if (const auto measured = find_trace(database, {.trial = trial, .kind = TraceKind::measured}))
      found.parts.push_back({kMeasured, read_trace(database, *measured)});
  found.parts.push_back({label_of(kind), read_trace(database, trace)});
  return found;
}

std::optional<TraceId> number_in(const std::string& name) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return TraceId{number};
}

}  // namespace

std::vector<std::string> names_of_traces(const Database& database, std::size_t most) {
  Statement row(database,
                "SELECT trial.name FROM trial JOIN trace ON trace.trial = trial.id GROUP BY trial.name"
                " ORDER BY min(trace.id) LIMIT ?");
  row.with(static_cast<std::int64_t>(most));
  std::vector<std::string> names;
  while (row.step()) names.push_back(row.text(0));
  return names;
}

std::optional<NamedTrace> find_named_trace(const Database& database, const TraceQuestion& question) {
  if (std::optional<NamedTrace> named = by_name(database, question)) return named;
  const std::optional<TraceId> number = number_in(question.name);
  if (!number) return std::nullopt;
  std::optional<NamedTrace> found = by_number(database, *number);
  if (found && question.revision && found->revision != question.revision)
    throw_problem({database.file().string()},
                  fmt::format("--revision {}: trace {} is not of this revision; leave --revision out",
                              *question.revision, question.name));
  return found;
}

}  // namespace lacuna
