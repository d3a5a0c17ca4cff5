#include "app/ledger.h"

#include "app/records.h"
#include "foundation/interrupt.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

/// Plugin files that the experiment's components come from, each once.
std::vector<PluginFileRecord> plugin_files(const Rig& rig) {
  std::vector<std::string> used = {rig.experiment.model.robot, rig.experiment.target.kind};
  for (const EffectEntry& entry : rig.definition.effects) used.push_back(entry.effect);
  std::vector<PluginFileRecord> files;
  for (const PluginListing& listing : rig.catalog->list()) {
    const bool wanted = std::find(used.begin(), used.end(), listing.name) != used.end();
    const bool known =
        std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.sha256 == listing.sha256; });
    if (wanted && !known) files.push_back({listing.file.string(), listing.sha256, listing.build_id});
  }
  return files;
}

}  // namespace

std::filesystem::path database_of(const CommonOptions& options, const Experiment& experiment) {
  return options.database.empty() ? std::filesystem::path(experiment.name + ".db") : options.database;
}

Ledger::Ledger(const CommonOptions& options, const Rig& rig, std::uint64_t seed, int threads)
    : database_(Database::open(database_of(options, rig.experiment))), store_(database_), seed_(seed) {
  Transaction transaction(database_);
  store_.begin_run({command_line(), seed, threads}, provenance_of_this_program());
  store_.record_plugins(plugin_files(rig));
  experiment_ = store_.record_experiment(
      {rig.experiment.name, rig.experiment.file.string(), rig.experiment.text, rig.experiment.overrides});
  transaction.commit();
}

Ledger::~Ledger() {
  if (!interrupt_requested()) return;
  try {
    store_.end_run(RunEnding::interrupted);
  } catch (const std::exception&) {
    return;  // the run stays without an end, which says the same
  }
}

StoredRevision Ledger::enter(const Rig& rig) { return store_.find_or_add_revision(experiment_, revision_record(rig)); }

std::string Ledger::settings(const Rig& rig) const {
  const FitSection& fit = rig.experiment.fit;
  std::string text =
      fmt::format("{} segments {} horizon {} starts {} loss {} {} iterations {} seed {} lacuna {}", fit.method,
                  fmt::join(fit.segments, ","), fit.horizon, fit.starts, fit.loss, fit.loss_scale, fit.max_iterations,
                  seed_, provenance_of_this_program().source_revision);
  for (const PluginFileRecord& file : plugin_files(rig)) text += " " + file.sha256;
  return text;
}

std::optional<FitResult> Ledger::known_fit(const StoredRevision& revision, const Rig& rig) const {
  const std::optional<StoredFit> stored = store_.last_fit_of(revision.id, settings(rig));
  if (!stored) return std::nullopt;
  return fit_result(stored->record);
}

void Ledger::keep(const StoredRevision& revision, const Rig& rig, const FitResult& fit) {
  store_.record_fit(revision.id, fit_record(fit, rig.experiment.fit, settings(rig)));
}

std::vector<TrialId> Ledger::ids_of(const std::vector<Trial>& trials) {
  std::vector<TrialId> ids;
  for (const Trial& trial : trials) ids.push_back(store_.find_or_add_trial(experiment_, trial_record(trial)));
  return ids;
}

void Ledger::keep(const StoredRevision& revision, const Rig& rig, const std::vector<Trial>& trials,
                  const Comparison& comparison, bool refitted, std::optional<int> look, double step) {
  Transaction transaction(database_);
  const std::vector<TrialId> ids = ids_of(trials);
  ComparisonRecord record = comparison_record(comparison, ids);
  record.kind = refitted ? ComparisonKind::refitted : ComparisonKind::as_written;
  record.look = look;
  record.step = step;
  if (refitted) {
    const std::optional<StoredFit> fit = store_.last_fit_of(revision.id, settings(rig));
    if (fit) record.fit = fit->id;
  }
  const ComparisonId id = store_.record_comparison(revision.id, record);
  for (std::size_t i = 0; i < comparison.trials.size(); ++i) {
    store_.record_trace(ids[i], TraceKind::measured, trials[i].measured, TracePrecision::float64);
    store_.record_trace(ids[i], TraceKind::predicted, predicted_series(trials[i], comparison.trials[i]),
                        TracePrecision::float32, id);
  }
  transaction.commit();
}

int Ledger::count_look(const StoredRevision& revision) {
  return store_.count_holdout_look(revision.id, command_line());
}

void Ledger::done() { store_.end_run(RunEnding::done); }

}  // namespace lacuna
