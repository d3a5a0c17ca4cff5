#pragma once

#include "app/terminal/options.h"
#include "app/terminal/replace_file.h"
#include "app/workspace/result_recorder.h"
#include "app/workspace/open_experiment.h"
#include "data_checks/data_warning.h"
#include "where_it_fails/where_it_fails.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "report/text/change_text.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// When a model becomes a revision in the database.
enum class Entry {
  at_once,        ///< it is what the experiment file says
  with_its_file,  ///< by `ExperimentWorkflow::enter`, because the file is edited only then
};

/// A command's way from an experiment file to a fitted, stored model. One fitter for all commands:
/// a revision that was fitted before with the same settings keeps its fit.
class ExperimentWorkflow {
 public:
  explicit ExperimentWorkflow(const CommonOptions& options);
  /// For an experiment that was opened already; `opened` must outlive the workflow.
  ExperimentWorkflow(const CommonOptions& options, OpenExperiment opened, Entry entry = Entry::at_once);

  struct Fitted {
    FitResult result;
    bool known = false;  ///< it was in the database
  };
  /// Fits the rig's model to its fit trials, or finds the fit in the database. Where the time limit is reached it
  /// throws `TimeIsUp`, or, if that is `wanted`, gives and stores the best values so far.
  enum class AtTimeLimit { nothing, best_so_far };
  Fitted fit_model(AtTimeLimit wanted = AtTimeLimit::nothing);
  /// Compares with all trials, or with the fit trials alone; counts a look where held-out ones are among them.
  struct Compared {
    Comparison result;
    int look = 0;
    ComparisonId id;
  };
  Compared compare_model(const FitResult& fit, bool refitted, bool with_held_out, bool cross_check = false);
  /// Gives the experiment file its new text and enters the model with its fit and its comparison with the fit trials,
  /// all or nothing. A process that is killed here leaves both undone, or the file alone: whatever command comes next
  /// then enters the model, as after an edit by hand.
  void enter(const Fitted& fitted, const Comparison& comparison, TextReplacement& file);
  /// Where the model fails on the fit trials of a comparison with all of the rig's.
  WhereItFails where_it_fails(const FitResult& fit, const Comparison& comparison) const;
  /// What speaks against the data (data_checks/data_checks.h).
  std::vector<DataWarning> doubts(const FitResult& fit) const;

  const OpenExperiment& opened() const { return opened_; }
  /// Of a model that was entered.
  const StoredRevision& revision() const { return revision_.value(); }
  ResultRecorder& recorder() { return recorder_; }
  /// Of the command; reports to `progress`.
  Work work(ProgressCallback progress = {}) const { return options_.work(std::move(progress)); }

 private:
  ComparisonId keep(const std::vector<Trial>& trials, const Comparison& comparison, bool refitted,
                    std::optional<int> look);

  const CommonOptions& options_;
  OpenExperiment opened_;
  std::uint64_t seed_;
  std::string integration_;  ///< how the model is integrated, a sentence
  ResultRecorder recorder_;
  std::optional<StoredRevision> revision_;
};

/// Fits the rig's model, which the experiment file says, and scores it on the fit files; held-out files are not looked
/// at. For a command that edits the file afterwards: Ctrl-C says that the file is as it was.
RevisionErrors errors_before_edit(const CommonOptions& options, OpenExperiment opened);
/// The same for the model that the edited file will say, and then the edit. Whatever ends the work before (an error,
/// Ctrl-C, a power cut) leaves file and database without it.
RevisionErrors errors_with_edit(const CommonOptions& options, OpenExperiment opened, const std::string& text,
                                const std::string& edited);

}  // namespace lacuna
