#pragma once

#include "answer/calibration.h"
#include "runs/database.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// A first verdict with what spoke for it, and whether it is right.
struct JudgedVerdict {
  std::string rig;  ///< family of rigs
  std::string verdict;
  lacuna::Evidence evidence;
  double is_right = 0.0;
};

/// All of a version and a dirty set but `cannot_tell`, which states no probability. See `is_true`.
std::vector<JudgedVerdict> judged_verdicts(const Database& database, const std::string& version,
                                           const std::string& set);

/// Fits the log odds of each verdict, whose slopes have the sign that each figure of evidence must have, with the
/// penalty of weights that tells each rig best from the others. Verdicts with few cases are told from fewer figures,
/// those with less than three from nothing.
lacuna::Calibration calibrate(const std::vector<JudgedVerdict>& verdicts);

/// For all cases, and for those of all rigs but one, each in turn.
lacuna::ShippedCalibration calibrate_and_leave_out(const std::vector<JudgedVerdict>& verdicts);

}  // namespace hidden_effects
