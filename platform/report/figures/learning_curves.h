#pragma once

#include "report/figures/figure.h"
#include "report/figures/spread.h"
#include "storage/eea/eea_records.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What the replicates of one experiment had learnt after each trial of the target.
struct LearningCurve {
  /// A pass of one replicate.
  struct Point {
    int trials = 0;      ///< of the target that its models were fitted to
    double steps = 0.0;  ///< integration steps of models and tests since the run began
    double error = 0.0;  ///< of the best model
  };
  std::string experiment;
  std::string error;  ///< what it is: a name of the objective metric's, or the metric of models
  std::string unit;   ///< SI; "1" where it has none
  std::vector<std::vector<Point>> runs;
};

/// The passes of several runs as a curve. `error` names a figure of the objective metric, or is empty for the score
/// that models are searched by, whose unit is not known. A run without that figure has no points.
LearningCurve learning_curve(const std::string& experiment, const std::vector<std::vector<PassRow>>& runs,
                             const std::string& error);

/// The figures of the objective metric that all of the runs have, those of whole groups of parameters first.
std::vector<std::string> errors_in(const std::vector<std::vector<PassRow>>& runs);

/// The mean error of the runs after so many trials: of logarithms (a factor of 1.1 counts alike everywhere) where all
/// errors of all curves are above 0, else of the errors. A run that stopped early keeps its last error.
class MeanError {
 public:
  explicit MeanError(const std::vector<LearningCurve>& curves);

  bool logarithmic() const { return logarithmic_; }
  /// With the ends of the mean's 95 % interval, which fewer than three runs do not have.
  struct Interval {
    double mean = 0.0, lower = 0.0, upper = 0.0;
  };
  Interval after(const LearningCurve& curve, int trials) const;
  /// The fewest trials after which the mean error is at most `error`; nothing where it never is.
  std::optional<int> trials_to(const LearningCurve& curve, double error) const;

 private:
  bool logarithmic_ = false;
};

/// Trials needed for the error that another experiment's runs have in the end, with a 95 % interval from 1 000
/// bootstrap samples of the runs of both (fixed seed).
struct TrialsNeeded {
  std::optional<int> trials;  ///< nothing: not reached
  std::optional<int> lower, upper;
};
TrialsNeeded trials_needed(const MeanError& mean, const LearningCurve& curve, const LearningCurve& against);

/// One line an experiment: error after the first, the middle and the last trial, steps, and, with `against` (one of
/// them), trials needed for its last error.
std::string learning_table(const std::vector<LearningCurve>& curves, const LearningCurve* against);

/// Mean errors with 95 % bars by trials of the target.
Figure error_by_trials(const std::vector<LearningCurve>& curves);
/// The same by simulated steps, on logarithmic axes; passes stand at the mean of their steps.
Figure error_by_steps(const std::vector<LearningCurve>& curves);

}  // namespace lacuna
