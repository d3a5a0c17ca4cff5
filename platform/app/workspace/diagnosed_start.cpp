#include "app/workspace/diagnosed_start.h"

#include "app/terminal/short_number.h"
#include "app/workspace/records.h"
#include "candidates/wrong_value.h"
#include "storage/results/result_store.h"

#include <algorithm>

namespace lacuna {
namespace {

/// Asks the database about the revision that the rig is, if it has that.
template <class Answer, class Question>
Answer asked(const CommonOptions& options, const OpenExperiment& base, const Question& question) {
  const std::filesystem::path file = database_of(options, base.experiment);
  if (!std::filesystem::exists(file)) return {};
  Database database = Database::open_read_only(file, options.stop);
  const ResultStore store(database);
  const std::optional<ExperimentId> experiment = store.find_experiment(base.experiment.name);
  if (!experiment) return {};
  const std::optional<StoredRevision> revision = store.find_revision(*experiment, revision_record(base));
  return revision ? question(store, revision->id) : Answer{};
}

std::vector<CandidateValueRecord> diagnosed_values(const CommonOptions& options, const OpenExperiment& base,
                                                   const EffectEntry& entry) {
  if (entry.where.size() > 1) return {};
  return asked<std::vector<CandidateValueRecord>>(options, base, [&](const ResultStore& store, RevisionId revision) {
    return store.diagnosed_values(revision, entry.effect, entry.where.empty() ? "world" : entry.where.front());
  });
}

}  // namespace

std::map<std::string, double> diagnosed_start(const CommonOptions& options, const OpenExperiment& base,
                                              const OpenExperiment& extended, const EffectEntry& entry) {
  std::map<std::string, double> start;
  for (const CandidateValueRecord& found : diagnosed_values(options, base, entry)) {
    for (const FreeValue& free : extended.definition.free)
      if (belongs_to(free, entry) && last_name(free.address) == found.name)
        start[found.name] = std::clamp(short_number(found.value), free.lower, free.upper);
  }
  return start;
}

std::vector<EffectAtPlace> diagnosed_answer(const CommonOptions& options, const OpenExperiment& base) {
  return asked<std::vector<EffectAtPlace>>(
      options, base, [](const ResultStore& store, RevisionId revision) { return store.diagnosed_answer(revision); });
}

}  // namespace lacuna
