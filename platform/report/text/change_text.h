#pragma once

#include "fitting/comparison.h"
#include "fitting/fit.h"

#include <string>
#include <vector>

namespace lacuna {

/// A fitted revision and its errors on the fit files.
struct RevisionErrors {
  int revision = 0;
  FitResult fit;
  Comparison comparison;
};

/// An error that a change of the model made larger: of a channel in one file, over a horizon or in a free run.
struct ErrorRise {
  std::string trial;
  bool held_out = false;
  std::string channel;
  std::string unit;
  double horizon = 0.0;  ///< s; 0: the free run
  double before = 0.0;   ///< RMSE
  double after = 0.0;    ///< infinite where the model cannot be simulated any more
};

/// Those that rose by more than a hundredth, of all files that both comparisons have.
std::vector<ErrorRise> error_rises(const Comparison& before, const Comparison& after);

/// What a change of the model did on the fit files: error by channel before → after, in units and
/// multiples of the floor, the values that moved, and what rose. `undo`: the command that takes the change back.
std::string change_text(const RevisionErrors& before, const RevisionErrors& after, const std::string& undo = {});
std::string change_json(const std::string& change, const RevisionErrors& before, const RevisionErrors& after,
                        const std::string& undo = {});

}  // namespace lacuna
