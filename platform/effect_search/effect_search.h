#pragma once

#include "effect_search/effect_look.h"

#include <vector>

namespace lacuna {

/// What a search found: all sets that were fitted, and what follows from them.
struct SearchResult {
  CellLayout layout;              ///< of the sets' products
  std::vector<double> lengths;    ///< s, of all predictions
  std::vector<FittedModel> sets;  ///< the model as it is first
  Decision decision;              ///< its numbers are indices into `sets`
  bool by_all_lengths = false;    ///< the shorter lengths showed nothing
  std::vector<Untestable> untestable;
  int fits = 0;
};

/// Searches for the effects that a model lacks (docs/explanation/diagnosis.md). Throws `NothingPredictable`,
/// `Interrupted`.
SearchResult search_effects(const MissingTask& task);

}  // namespace lacuna
