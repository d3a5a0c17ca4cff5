#pragma once

#include "app/ledger.h"
#include "app/options.h"
#include "app/rig.h"
#include "diagnosis/where_it_fails.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "report/change_text.h"

namespace lacuna {

/// A command's way from an experiment file to a fitted, stored model. One fitter for all commands:
/// a revision that was fitted before with the same settings keeps its fit.
class Workbench {
 public:
  explicit Workbench(const CommonOptions& options);
  /// For an experiment that was opened already; `rig` must outlive the bench.
  Workbench(const CommonOptions& options, Rig rig);

  struct Fitted {
    FitResult result;
    bool known = false;  ///< it was in the database
  };
  /// Fits the rig's model to its fit trials, or finds the fit in the database.
  Fitted fit_model();
  /// Compares with all trials, or with the fit trials alone; counts a look where held-out ones are among them.
  struct Compared {
    Comparison result;
    int look = 0;
    ComparisonId id;
  };
  Compared compare_model(const FitResult& fit, bool refitted, bool with_held_out);
  /// Where the model fails on the fit trials of a comparison with all of the rig's.
  WhereItFails where_it_fails(const FitResult& fit, const Comparison& comparison) const;
  /// What of the data allows no verdict on a fitted model (diagnosis/data_doubts.h), sentences.
  std::vector<std::string> faults(const FitResult& fit) const;

  const Rig& rig() const { return rig_; }
  const StoredRevision& revision() const { return revision_; }
  Ledger& ledger() { return ledger_; }
  int threads() const { return threads_; }

 private:
  const CommonOptions& options_;
  Rig rig_;
  std::uint64_t seed_;
  int threads_;
  Ledger ledger_;
  StoredRevision revision_;
};

/// Fits the rig's model and scores it on the fit files; held-out files are not looked at.
RevisionErrors errors_of(const CommonOptions& options, Rig rig);
/// The same for a command that edits the experiment file only after its refits, so that whatever ends them (an
/// error, Ctrl-C, a power cut) leaves the file as it was. Ctrl-C says so.
RevisionErrors errors_before_edit(const CommonOptions& options, Rig rig);

}  // namespace lacuna
