#pragma once

#include "foundation/effect_at_place.h"
#include "storage/core/database.h"
#include "storage/core/provenance.h"
#include "storage/core/records.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// The results of experiments as typed records. Nothing outside storage/ writes SQL.
///
/// A store that writes belongs to one run: `begin_run` comes first, and each `record_...` is one
/// transaction unless the caller has begun a wider one on the database:
///
///     Database database = Database::open("rig.db");
///     ResultStore store(database);
///     store.begin_run({...}, provenance_of_this_program());
///     const ExperimentId experiment = store.record_experiment({...});
///     Transaction transaction(database);
///     ...
///     transaction.commit();
///     store.end_run(RunEnding::done);
///
/// A run that is not ended (an exception) is stored as failed. Replicates of an experiment are a run
/// each: `begin_run` again, or a store each. One thread at a time. Throws
/// `Error` with a sentence for whatever keeps the database from being read or written.
class ResultStore {
 public:
  /// The database outlives the store.
  explicit ResultStore(Database& database);
  ~ResultStore();
  ResultStore(const ResultStore&) = delete;
  ResultStore& operator=(const ResultStore&) = delete;

  RunId begin_run(const RunRecord& run, const Provenance& provenance);
  /// Continues a run of this file that did not end as `done`; it keeps its command and provenance.
  void continue_run(RunId run);
  void end_run(RunEnding ending);
  /// From now on somebody else ends the run, or the runs, that were begun or continued.
  void hand_over() { ended_ = true; }
  void record_plugins(const std::vector<PluginFileRecord>& files);
  void record_robot_files(const std::vector<RobotFileRecord>& files);

  /// Finds the experiment by name and stores this text of it if it is new.
  ExperimentId record_experiment(const ExperimentRecord& experiment);

  /// Finds the revision by its digest, or adds it with the next number; its parent is the
  /// revision that the experiment used last. From now on this one is.
  StoredRevision find_or_add_revision(ExperimentId experiment, const RevisionRecord& revision);
  TrialId find_or_add_trial(ExperimentId experiment, const TrialRecord& trial);

  FitId record_fit(RevisionId revision, const FitRecord& fit);
  /// A converged or unconverged fit of this revision made with the same settings, the latest one.
  std::optional<StoredFit> last_fit_of(RevisionId revision, const std::string& settings) const;

  /// Counts a look at the held-out trials and returns its number, from 1, over all revisions of
  /// the experiment. To be called before anything of them is shown; it is never taken back.
  int count_holdout_look(RevisionId revision, const std::string& command);
  int holdout_looks(ExperimentId experiment) const;

  ComparisonId record_comparison(RevisionId revision, const ComparisonRecord& comparison);
  /// Where the model fails in that comparison, JSON.
  void record_where_it_fails(ComparisonId comparison, const std::string& document);
  /// The latest comparison of that kind; with `held_out` the latest that scored held-out trials.
  std::optional<StoredComparison> latest_comparison(RevisionId revision, ComparisonKind kind,
                                                    bool held_out = false) const;

  /// Stores a finished diagnosis, unless this revision has one with the same settings.
  DiagnosisId record_diagnosis(RevisionId revision, const DiagnosisRecord& diagnosis);
  /// Of one that is not finished: what is kept of it to go on from stays.
  DiagnosisId record_stopped_diagnosis(RevisionId revision, const DiagnosisRecord& diagnosis);
  /// The document of the diagnosis of this revision with the same settings.
  std::optional<std::string> diagnosis_of(RevisionId revision, const std::string& settings) const;
  /// What the latest diagnosis that names this effect there found for its parameters, the best model with it: of this
  /// revision, or else of the nearest one that it was made from. Those that have no value are left out.
  std::vector<CandidateValueRecord> diagnosed_values(RevisionId revision, const std::string& effect,
                                                     const std::string& place) const;
  /// What the latest diagnosis of this revision found to be missing. Empty: nothing.
  std::vector<EffectAtPlace> diagnosed_answer(RevisionId revision) const;
  /// Stores where a diagnosis stands, JSON, in place of what it stored before; a finished one of the
  /// revision removes all of its own.
  void keep_unfinished_diagnosis(RevisionId revision, const std::string& settings, const std::string& document);
  std::optional<std::string> unfinished_diagnosis_of(RevisionId revision, const std::string& settings) const;

  /// Stores samples; a prediction belongs to a comparison, what was measured to its trial alone. (Predictions of an
  /// EEA run's models: EeaStore.)
  /// Recording the same measured trace again returns the one that is there.
  TraceId record_trace(TrialId trial, TraceKind kind, const TimeSeries& series,
                       TracePrecision precision = TracePrecision::float32,
                       std::optional<ComparisonId> comparison = std::nullopt);
  /// Throws `Error` if the stored bytes are not those that were written.
  TimeSeries trace(TraceId trace) const;
  std::optional<TraceId> find_trace(TrialId trial, TraceKind kind,
                                    std::optional<ComparisonId> comparison = std::nullopt) const;

  /// Nothing where the database does not know the name.
  std::optional<ExperimentId> find_experiment(const std::string& name) const;
  std::vector<StoredTrial> trials(ExperimentId experiment) const;
  std::optional<StoredRevision> current_revision(ExperimentId experiment) const;
  std::optional<StoredRevision> revision(ExperimentId experiment, int number) const;
  std::optional<StoredRevision> find_revision(ExperimentId experiment, const RevisionRecord& revision) const;
  RevisionRecord revision_record(RevisionId revision) const;
  /// By revision number, then channel. A revision that was never compared has one row without errors.
  std::vector<HistoryRow> history(ExperimentId experiment) const;

 private:
  std::int64_t next_id(const char* table);
  std::optional<StoredRevision> find_revision(ExperimentId experiment, const std::string& digest) const;
  void add_revision(ExperimentId experiment, const RevisionRecord& record, const std::string& digest);
  RunId run() const;

  Database& database_;
  std::optional<RunId> run_;
  bool ended_ = false;  ///< or nothing to end
};

/// The identity of a run that carries a task out: the same for whoever does, so that a merge knows it.
std::string identity_of_run(const std::string& task, RunId run);

/// Whether the run is there and has come to its end.
bool is_done(const Database& database, RunId run);
/// Without an ending, the run has not ended.
void set_run_ending(Database& database, RunId run, std::optional<RunEnding> ending);
/// Of many runs, in one transaction.
void end_runs(Database& database, const std::vector<RunId>& runs, RunEnding ending);
/// For what ends a run when nothing else has.
void end_run_unless_ended(Database& database, RunId run, RunEnding ending);

}  // namespace lacuna
