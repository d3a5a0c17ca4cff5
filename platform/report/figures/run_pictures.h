#pragma once

#include "report/figures/figure.h"
#include "storage/eea/eea_store.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What is drawn of a run.
struct DrawnRun {
  EeaRunRecord record;
  std::vector<PassRow> passes;
  std::vector<TargetTrialRow> trials;
  /// Paths of the centre of mass in the first and the last trial whose test a model chose: of the target, and as that
  /// model predicted it.
  struct Path {
    int trial = 0;
    TimeSeries target, model;
  };
  std::vector<Path> paths;
};

/// Reads what is drawn.
DrawnRun drawn_run(const EeaStore& store);

struct NamedFigure {
  std::string name;  ///< of the file, without its ending
  Figure figure;
};

/// Error by pass; the objective metric's groups by pass; parameters of the last pass against the truth, with standard
/// deviations between runs (the seed's Fig. 5), or their distance from it where each run hides values of its own;
/// distance predicted and measured by pass, with 95 % intervals of the mean (Fig. 6); paths of the first run at its
/// first and last pass (Fig. 4). What the runs do not have is left out.
std::vector<NamedFigure> run_figures(const std::vector<DrawnRun>& runs, const std::string& title);

}  // namespace lacuna
