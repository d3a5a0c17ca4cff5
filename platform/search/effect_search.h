#pragma once

#include "search/effect_look.h"

#include <memory>
#include <optional>
#include <vector>

namespace lacuna {

/// The result of a search: all sets that were fitted, and the decision.
struct SearchResult {
  std::shared_ptr<const SearchData> data;
  CellLayout layout;                  ///< of the sets' products
  std::vector<FittedModel> sets;      ///< the model as it is first
  std::vector<LookedBeside> looked;   ///< all candidates examined beside some set
  Decision decision;                  ///< its numbers are indices into `sets`
  std::optional<FittedModel> spread;  ///< the answer on every joint where the data determine its values (spread.h)
  bool by_all_lengths = false;  ///< the answer was decided with all lengths because the shorter ones showed nothing
  std::size_t hypotheses = 0;   ///< effect × place
  std::vector<Untestable> untestable;
  int fits = 0;
  int nested = 0, unnested = 0;  ///< number of sets with a fitted part, and of those that cost more than it
  bool stopped = false;  ///< by the time limit, which is then lifted: the result covers the sets fitted until then

  /// The model as it is where nothing is missing.
  const FittedModel& answer() const { return spread ? *spread : sets[decision.answer]; }
};

/// Searches for the effects that a model lacks (docs/explanation/diagnosis.md). Throws `NothingPredictable`,
/// `Interrupted`, and `TimeIsUp` where the limit is reached before the model as it is was fitted.
SearchResult search_effects(const EffectSearchTask& task);

}  // namespace lacuna
