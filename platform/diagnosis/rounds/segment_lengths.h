#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "diagnosis/rounds/cut_trials.h"
#include "diagnosis/rounds/round.h"

#include <string>
#include <vector>

namespace lacuna {

/// What is refitted over segments of other lengths: the answer of a finished search. Everything referred to must live
/// until the call returns.
struct LengthTask {
  CutTask cut;                 ///< of the search: the model as it was, the trials as measured, the length
  const Contender& contender;  ///< with the found effects
  const Round& last;           ///< its noise
  const Refit& fit;            ///< of the contender, over the search's own segments
  int threads = 1;
};

/// Fits the contender over segments of 0.1 s, 0.5 s and the longest horizon on which the uncertainty of a start, told
/// by as much data as a segment of the search, grows to no more than twice the noise (fitting/stages.h); without the
/// length that the search was made over; under the noise that the last round found. Shorter ones first. Empty for
/// trials that cannot be cut, because the sensors do not tell the state, and for those that are too short.
std::vector<EffectsAtLength> refit_at_lengths(const LengthTask& task);

/// What the lengths say of the answer's effects.
struct LengthVerdict {
  bool survives = true;  ///< sign and size of all effects
  std::vector<std::string> findings;
};

/// An effect counts only if its sign and size survive a change of segment length: each parameter that the data tell
/// apart from its neutral value must keep its side of it, and be as large to a factor of 1.5, unless the 95 % intervals
/// overlap or the data at that length speak no more against the answer's values than noise would. Shapes (parameters
/// that are not neutral to begin with, such as Stribeck's velocity) may move. `found`: over segments of `segment` s.
LengthVerdict judge_lengths(const std::vector<FoundEffect>& found, double segment,
                            const std::vector<EffectsAtLength>& others, const PluginCatalog& catalog);

}  // namespace lacuna
