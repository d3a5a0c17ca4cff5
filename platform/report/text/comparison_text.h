#pragma once

#include "data_checks/data_warning.h"
#include "evaluation/model/known_setups.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"

#include <string>
#include <vector>

namespace lacuna {

/// What `compare` prints besides the comparison itself.
struct ComparisonHeading {
  std::string experiment;
  int look = 0;  ///< number of this look at held-out data; 0: none was taken
  bool refitted = true;
  bool reused = false;  ///< the fit was taken from the database
  double fit_seconds = 0.0;
  std::vector<KnownSetup> setups = {};  ///< of the recordings
};

/// Errors by channel and trial in units and multiples of the floor, fit and held-out apart, with
/// the floor's origin, the numerical share, and restarted horizons; see METHOD's sketch.
std::string comparison_text(const ComparisonHeading& heading, const Comparison& comparison, const FitResult& fit);

/// How far the two engines are apart, a line a channel.
std::string cross_check_text(const CrossCheck& check);

/// The values of a fit with their 95 % intervals, and what the data cannot tell.
std::string fit_text(const FitResult& fit);

/// What is wrong with the data of a fit (data_checks/data_checks.h), and what that means, and what limits
/// what they can tell; empty where nothing does.
std::string data_checks_text(const std::vector<DataWarning>& doubts);

}  // namespace lacuna
