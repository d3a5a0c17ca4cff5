#include "app/workspace/result_recorder.h"

#include "app/workspace/records.h"
#include "app/workspace/used_plugins.h"
#include "documents/kept_fits_json.h"
#include "storage/core/storage_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr const char* kStopped = " stopped by the time limit";  ///< behind the settings of what is not finished

Database open_or_copy(const std::filesystem::path& file, const Stop& stop) {
  return std::filesystem::exists(file) && !is_writable(file) ? Database::open_copy(file, stop)
                                                             : Database::open(file, stop);
}

}  // namespace

ResultRecorder::ResultRecorder(const CommonOptions& options, const OpenExperiment& opened, std::uint64_t seed,
                               int threads)
    : database_(open_or_copy(database_of(options, opened.experiment), options.stop)),
      store_(database_),
      seed_(seed),
      stop_(options.stop) {
  Transaction transaction(database_);
  store_.begin_run({command_line(), seed, threads, options.task}, provenance_of_this_program());
  store_.record_plugins(plugins_of_model(opened.experiment, *opened.catalog));
  experiment_ =
      store_.record_experiment({opened.experiment.name, opened.experiment.file.string(), opened.experiment.text,
                                opened.experiment.overrides, opened.experiment.decided});
  transaction.commit();
}

ResultRecorder::~ResultRecorder() {
  if (done_ || (!stop_.is_due() && !stop_.limit_was_reached())) return;
  try {
    store_.end_run(RunEnding::interrupted);
  } catch (const std::exception&) {
    return;  // the run stays without an end, which says the same
  }
}

void ResultRecorder::check_kept() const {
  if (!is_writable(file())) throw_read_only(file());
}

StoredRevision ResultRecorder::enter(const OpenExperiment& opened) {
  return store_.find_or_add_revision(experiment_, revision_record(opened));
}

std::optional<StoredRevision> ResultRecorder::find(const OpenExperiment& opened) const {
  return store_.find_revision(experiment_, revision_record(opened));
}

void ResultRecorder::in_one_transaction(const std::function<void()>& work) {
  Transaction transaction(database_);
  work();
  transaction.commit();
}

std::string ResultRecorder::settings(const OpenExperiment& opened) const {
  const FitSection& fit = opened.experiment.fit;
  std::string text =
      fmt::format("{} segments {} horizon {} starts {} loss {} {} iterations {} seed {} lacuna {}", fit.method,
                  fmt::join(fit.segments, ","), fit.horizon, fit.starts, fit.loss, fit.loss_scale, fit.max_iterations,
                  seed_, provenance_of_this_program().source_revision);
  for (const PluginFileRecord& file : plugins_of_model(opened.experiment, *opened.catalog)) text += " " + file.sha256;
  return text;
}

std::optional<FitResult> ResultRecorder::known_fit(const StoredRevision& revision, const OpenExperiment& opened) const {
  const std::optional<StoredFit> stored = store_.last_fit_of(revision.id, settings(opened));
  if (!stored) return std::nullopt;
  return fit_result(stored->record);
}

void ResultRecorder::keep(const StoredRevision& revision, const OpenExperiment& opened, const FitResult& fit) {
  store_.record_fit(revision.id,
                    fit_record(fit, opened.experiment.fit, settings(opened) + (fit.stopped ? kStopped : "")));
}

void ResultRecorder::keep_stopped(const StoredRevision& revision, const OpenExperiment& opened,
                                  const std::vector<std::string>& among, const Diagnosis& diagnosis) {
  store_.record_stopped_diagnosis(revision.id, diagnosis_record(diagnosis, settings(opened, among) + kStopped));
}

/// A diagnosis also follows from the effects that there are to try, and from the declared noise.
std::string ResultRecorder::settings(const OpenExperiment& opened, const std::vector<std::string>& among) const {
  std::string text = settings(opened) + fmt::format(" diagnosis among [{}]", fmt::join(among, ","));
  const NoiseSection& noise = opened.experiment.noise;
  for (const auto& [joint, deviation] : noise.process)
    text += fmt::format(" process {} {} {}", joint, deviation, noise.process_correlation_time);
  for (const PluginListing& listing : opened.catalog->list())
    if (listing.kind == "effect") text += " " + listing.sha256;
  return text;
}

std::optional<std::string> ResultRecorder::known_diagnosis(const StoredRevision& revision, const OpenExperiment& opened,
                                                           const std::vector<std::string>& among) const {
  return store_.diagnosis_of(revision.id, settings(opened, among));
}

void ResultRecorder::keep(const StoredRevision& revision, const OpenExperiment& opened,
                          const std::vector<std::string>& among, const Diagnosis& diagnosis) {
  store_.record_diagnosis(revision.id, diagnosis_record(diagnosis, settings(opened, among)));
}

void ResultRecorder::keep_unfinished(const StoredRevision& revision, const OpenExperiment& opened,
                                     const std::vector<std::string>& among, const KeptFits& fits) {
  store_.keep_unfinished_diagnosis(revision.id, settings(opened, among), kept_fits_json(fits));
}

std::optional<KeptFits> ResultRecorder::unfinished_diagnosis(const StoredRevision& revision,
                                                             const OpenExperiment& opened,
                                                             const std::vector<std::string>& among) const {
  const std::optional<std::string> document = store_.unfinished_diagnosis_of(revision.id, settings(opened, among));
  return document ? read_kept_fits(*document) : std::nullopt;
}

std::vector<TrialId> ResultRecorder::ids_of(const std::vector<Trial>& trials, const ModelDefinition& definition) {
  std::vector<TrialId> ids;
  for (const Trial& trial : trials)
    ids.push_back(store_.find_or_add_trial(experiment_, trial_record(trial, definition)));
  return ids;
}

ComparisonId ResultRecorder::keep(const StoredRevision& revision, const OpenExperiment& opened,
                                  const std::vector<Trial>& trials, const Comparison& comparison, bool refitted,
                                  std::optional<int> look, double step) {
  Transaction transaction(database_);
  const std::vector<TrialId> ids = ids_of(trials, opened.definition);
  ComparisonRecord record = comparison_record(comparison, ids);
  record.kind = refitted ? ComparisonKind::refitted : ComparisonKind::as_written;
  record.look = look;
  record.step = step;
  if (refitted) {
    const std::optional<StoredFit> fit = store_.last_fit_of(revision.id, settings(opened));
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

int ResultRecorder::count_look(const StoredRevision& revision) {
  return store_.count_holdout_look(revision.id, command_line());
}

void ResultRecorder::done() {
  store_.end_run(RunEnding::done);
  done_ = true;
}

}  // namespace lacuna
