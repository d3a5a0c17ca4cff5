#pragma once

#include "fitting/starts/start_states.h"

#include <span>

namespace lacuna {

inline constexpr Eigen::Index kHeadSamples = 4;  ///< a head has at least so many, where samples are far apart

/// The end (one past) of a stretch's head: its first 50 ms, which tell its start and are not scored.
Eigen::Index head_end(const TrialPredictor& predictor, const Stretch& stretch, double length = kHead);

/// The first sample of a stretch that is scored: the one after the head, or, where nothing had to be estimated
/// because the start is given or cannot be measured, the stretch's first. At a trial's start, where what was before is
/// unknown, not before `memory` s have passed.
Eigen::Index first_scored(const TrialPredictor& predictor, const Stretch& stretch, const StartEstimate& estimate,
                          double memory);
/// The same with as much memory as the predictor's model has.
Eigen::Index first_scored(const TrialPredictor& predictor, const Stretch& stretch, const StartEstimate& estimate);

/// The start under which the model, with the values given, agrees best with the stretch's head of `length` s, and how
/// certain it is. Only measured coordinates are sought; exact ones (`given`) stay as they are. Not valid
/// if the model cannot be simulated there. Thread-safe for different workers.
StartEstimate fit_head(const TrialPredictor& predictor, const StartStates& states, const Stretch& stretch,
                       std::span<const double> values, int worker, double length = kHead);

}  // namespace lacuna
