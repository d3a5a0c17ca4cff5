#pragma once

#include "answer/diagnosis.h"
#include "app/terminal/options.h"
#include "app/workspace/open_experiment.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "search/kept_fits.h"
#include "storage/results/result_store.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What one command writes into its experiment's database. A command that ends by an exception is
/// stored as failed, by Ctrl-C or its time limit as interrupted. Of a database that may not be written to a temporary
/// copy is used: whoever finds there what was made before needs no more.
class ResultRecorder {
 public:
  ResultRecorder(const CommonOptions& options, const OpenExperiment& opened, std::uint64_t seed, int threads);
  ~ResultRecorder();
  ResultRecorder(const ResultRecorder&) = delete;
  ResultRecorder& operator=(const ResultRecorder&) = delete;

  /// Throws `Error` where nothing that is written would be kept. To be called before what takes long.
  void check_kept() const;

  /// The revision that the rig's model is; from now on the experiment's current one.
  StoredRevision enter(const OpenExperiment& opened);
  /// The revision that the rig's model is, where the database has it.
  std::optional<StoredRevision> find(const OpenExperiment& opened) const;
  /// What the work writes is in the database after it, or nothing of it where it or the commit throws.
  void in_one_transaction(const std::function<void()>& work);

  /// The fit of that revision with these settings, where it was made before.
  std::optional<FitResult> known_fit(const StoredRevision& revision, const OpenExperiment& opened) const;
  /// `known_fit` does not find one that the time limit stopped.
  void keep(const StoredRevision& revision, const OpenExperiment& opened, const FitResult& fit);
  /// Stores scores, floors, measured and predicted series of the trials compared.
  ComparisonId keep(const StoredRevision& revision, const OpenExperiment& opened, const std::vector<Trial>& trials,
                    const Comparison& comparison, bool refitted, std::optional<int> look, double step);
  /// Stores where the model fails in that comparison, JSON.
  void keep_where_it_fails(ComparisonId comparison, const std::string& document) {
    store_.record_where_it_fails(comparison, document);
  }

  /// The document of the diagnosis of that revision with these settings, among these effects, where it was made before.
  std::optional<std::string> known_diagnosis(const StoredRevision& revision, const OpenExperiment& opened,
                                             const std::vector<std::string>& among) const;
  void keep(const StoredRevision& revision, const OpenExperiment& opened, const std::vector<std::string>& among,
            const Diagnosis& diagnosis);
  /// One that the time limit stopped: neither found by `known_diagnosis` nor in the way of `unfinished_diagnosis`.
  void keep_stopped(const StoredRevision& revision, const OpenExperiment& opened, const std::vector<std::string>& among,
                    const Diagnosis& diagnosis);
  /// Where that diagnosis stands, for a later call to go on from.
  void keep_unfinished(const StoredRevision& revision, const OpenExperiment& opened,
                       const std::vector<std::string>& among, const KeptFits& fits);
  std::optional<KeptFits> unfinished_diagnosis(const StoredRevision& revision, const OpenExperiment& opened,
                                               const std::vector<std::string>& among) const;

  /// Counts a look at the held-out trials before anything of them is shown.
  int count_look(const StoredRevision& revision);
  void done();

  const std::filesystem::path& file() const { return database_.file(); }
  ExperimentId experiment() const { return experiment_; }
  const ResultStore& store() const { return store_; }

 private:
  std::string settings(const OpenExperiment& opened) const;
  std::string settings(const OpenExperiment& opened, const std::vector<std::string>& among) const;
  std::vector<TrialId> ids_of(const std::vector<Trial>& trials, const ModelDefinition& definition);

  Database database_;
  ResultStore store_;
  ExperimentId experiment_;
  std::uint64_t seed_;
  Stop stop_;
  bool done_ = false;
};

}  // namespace lacuna
