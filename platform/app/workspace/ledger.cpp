#include "app/workspace/ledger.h"

#include "app/workspace/records.h"
#include "app/workspace/used_plugins.h"
#include "documents/kept_fits_json.h"
#include "foundation/processes/interrupt.h"
#include "storage/core/storage_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr const char* kStopped = " stopped by the time limit";  ///< behind the settings of what is not finished

Database open_or_copy(const std::filesystem::path& file) {
  return std::filesystem::exists(file) && !is_writable(file) ? Database::open_copy(file) : Database::open(file);
}

}  // namespace

Ledger::Ledger(const CommonOptions& options, const Rig& rig, std::uint64_t seed, int threads)
    : database_(open_or_copy(database_of(options, rig.experiment))), store_(database_), seed_(seed) {
  Transaction transaction(database_);
  store_.begin_run({command_line(), seed, threads, options.task}, provenance_of_this_program());
  store_.record_plugins(plugins_of_model(rig.experiment, *rig.catalog));
  experiment_ = store_.record_experiment({rig.experiment.name, rig.experiment.file.string(), rig.experiment.text,
                                          rig.experiment.overrides, rig.experiment.decided});
  transaction.commit();
}

Ledger::~Ledger() {
  if (done_ || (!interrupt_requested() && !time_limit_was_reached())) return;
  try {
    store_.end_run(RunEnding::interrupted);
  } catch (const std::exception&) {
    return;  // the run stays without an end, which says the same
  }
}

void Ledger::check_kept() const {
  if (!is_writable(file())) throw_read_only(file());
}

StoredRevision Ledger::enter(const Rig& rig) { return store_.find_or_add_revision(experiment_, revision_record(rig)); }

std::optional<StoredRevision> Ledger::find(const Rig& rig) const {
  return store_.find_revision(experiment_, revision_record(rig));
}

void Ledger::in_one_transaction(const std::function<void()>& work) {
  Transaction transaction(database_);
  work();
  transaction.commit();
}

std::string Ledger::settings(const Rig& rig) const {
  const FitSection& fit = rig.experiment.fit;
  std::string text =
      fmt::format("{} segments {} horizon {} starts {} loss {} {} iterations {} seed {} lacuna {}", fit.method,
                  fmt::join(fit.segments, ","), fit.horizon, fit.starts, fit.loss, fit.loss_scale, fit.max_iterations,
                  seed_, provenance_of_this_program().source_revision);
  for (const PluginFileRecord& file : plugins_of_model(rig.experiment, *rig.catalog)) text += " " + file.sha256;
  return text;
}

std::optional<FitResult> Ledger::known_fit(const StoredRevision& revision, const Rig& rig) const {
  const std::optional<StoredFit> stored = store_.last_fit_of(revision.id, settings(rig));
  if (!stored) return std::nullopt;
  return fit_result(stored->record);
}

void Ledger::keep(const StoredRevision& revision, const Rig& rig, const FitResult& fit) {
  store_.record_fit(revision.id, fit_record(fit, rig.experiment.fit, settings(rig) + (fit.stopped ? kStopped : "")));
}

void Ledger::keep_stopped(const StoredRevision& revision, const Rig& rig, const std::vector<std::string>& among,
                          const Diagnosis& diagnosis) {
  store_.record_stopped_diagnosis(revision.id, diagnosis_record(diagnosis, settings(rig, among) + kStopped));
}

/// A diagnosis also follows from the effects that there are to try, and from the declared noise.
std::string Ledger::settings(const Rig& rig, const std::vector<std::string>& among) const {
  std::string text = settings(rig) + fmt::format(" diagnosis among [{}]", fmt::join(among, ","));
  const NoiseSection& noise = rig.experiment.noise;
  for (const auto& [joint, deviation] : noise.process)
    text += fmt::format(" process {} {} {}", joint, deviation, noise.process_correlation_time);
  for (const PluginListing& listing : rig.catalog->list())
    if (listing.kind == "effect") text += " " + listing.sha256;
  return text;
}

std::optional<std::string> Ledger::known_diagnosis(const StoredRevision& revision, const Rig& rig,
                                                   const std::vector<std::string>& among) const {
  return store_.diagnosis_of(revision.id, settings(rig, among));
}

void Ledger::keep(const StoredRevision& revision, const Rig& rig, const std::vector<std::string>& among,
                  const Diagnosis& diagnosis) {
  store_.record_diagnosis(revision.id, diagnosis_record(diagnosis, settings(rig, among)));
}

void Ledger::keep_unfinished(const StoredRevision& revision, const Rig& rig, const std::vector<std::string>& among,
                             const KeptFits& fits) {
  store_.keep_unfinished_diagnosis(revision.id, settings(rig, among), kept_fits_json(fits));
}

std::optional<KeptFits> Ledger::unfinished_diagnosis(const StoredRevision& revision, const Rig& rig,
                                                     const std::vector<std::string>& among) const {
  const std::optional<std::string> document = store_.unfinished_diagnosis_of(revision.id, settings(rig, among));
  return document ? read_kept_fits(*document) : std::nullopt;
}

std::vector<TrialId> Ledger::ids_of(const std::vector<Trial>& trials, const ModelDefinition& definition) {
  std::vector<TrialId> ids;
  for (const Trial& trial : trials)
    ids.push_back(store_.find_or_add_trial(experiment_, trial_record(trial, definition)));
  return ids;
}

ComparisonId Ledger::keep(const StoredRevision& revision, const Rig& rig, const std::vector<Trial>& trials,
                          const Comparison& comparison, bool refitted, std::optional<int> look, double step) {
  Transaction transaction(database_);
  const std::vector<TrialId> ids = ids_of(trials, rig.definition);
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
    if (const TimeSeries& commands = trials[i].commands.series; !commands.channels.empty())
      store_.record_trace(ids[i], TraceKind::commands, commands, TracePrecision::float64);
    store_.record_trace(ids[i], TraceKind::predicted, predicted_series(trials[i], comparison.trials[i]),
                        TracePrecision::float32, id);
  }
  transaction.commit();
  return id;
}

int Ledger::count_look(const StoredRevision& revision) {
  return store_.count_holdout_look(revision.id, command_line());
}

void Ledger::done() {
  store_.end_run(RunEnding::done);
  done_ = true;
}

}  // namespace lacuna
