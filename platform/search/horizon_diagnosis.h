#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "search/unfinished_search.h"

#include <functional>

namespace lacuna {

/// Where an earlier call for the same came to, and what gets where this one comes to.
struct SearchMemory {
  const UnfinishedSearch* resume = nullptr;  ///< null: from the beginning
  std::function<void(const UnfinishedSearch&)> keep = {};
};

/// Fits the model to free runs: its values. It takes long, and is asked for only where likelihoods decide.
using FreeRunFit = std::function<std::vector<double>()>;

/// METHOD: what effects, if any, the model lacks. Where its predictions are far from what noise allows they are what
/// sets of effects are judged by, over a ladder of horizons; doubts about the data stand beside the verdict then. Where
/// they are near, likelihoods are (`diagnose`), if the data are enough for them. `task` has no memory of its own; its
/// values are those of `fit`, where there is one. Where the time limit is reached (foundation/interrupt.h), it is
/// lifted and the diagnosis is `stopped`. Throws `Error` where the trials do not fit the model, and `Interrupted`.
Diagnosis find_missing_effects(const DiagnosisTask& task, const SearchMemory& memory = {}, const FreeRunFit& fit = {});

}  // namespace lacuna
