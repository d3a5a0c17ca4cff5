#pragma once

#include "fitting/starts/start_states.h"

#include <span>

namespace lacuna {

inline constexpr Eigen::Index kHeadSamples =
    4;  ///< the first part has at least this many samples, where they are far apart

/// The end (one past) of a stretch's first part: its first 50 ms, which determine its initial state and are not scored.
Eigen::Index head_end(const TrialPredictor& predictor, const Stretch& stretch, double length = kHead);

/// The first sample of a stretch that is scored: the one after the first part, or the stretch's first where nothing had
/// to be estimated because the initial state is given or cannot be measured. At a trial's start, where the earlier
/// commands are unknown, not before `memory` s have passed.
Eigen::Index first_scored(const TrialPredictor& predictor, const Stretch& stretch, const StartEstimate& estimate,
                          double memory);
/// The same with as much memory as the predictor's model has.
Eigen::Index first_scored(const TrialPredictor& predictor, const Stretch& stretch, const StartEstimate& estimate);

/// The initial state with which the model, with the given values, agrees best with the first `length` s of the stretch,
/// and its uncertainty. Only measured coordinates are estimated; exact ones (`given`) stay as they are. Not valid if
/// the model cannot be simulated there. Thread-safe for different workers.
StartEstimate fit_head(const TrialPredictor& predictor, const StartStates& states, const Stretch& stretch,
                       std::span<const double> values, int worker, double length = kHead);

}  // namespace lacuna
