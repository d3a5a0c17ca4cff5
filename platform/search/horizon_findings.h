#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "diagnosis/refit/refit.h"
#include "search/decisions.h"
#include "search/find_missing.h"

namespace lacuna {

/// What a search found: verdict, ranking, effects with intervals, errors by horizon.
Diagnosis findings_of(const Missing& missing);

/// A set's fit in the form in which values and intervals are stated. `timing`: the last value is when commands act.
Refit refit_of(const RankedSet& set, bool timing);

/// An answer that helps at some horizons alone is none.
void doubt_answer(const Helped& helped, Diagnosis& result);

/// Which effects held-out recordings spoke against: a sentence each.
std::vector<std::string> confirmation_notes(const Missing& missing);

/// What the ladder does not reach: a sentence, empty where it reaches a third of the longest trial.
std::string reach_note(const Ladder& ladder, const std::vector<Trial>& trials);

}  // namespace lacuna
