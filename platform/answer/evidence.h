#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

namespace lacuna {

/// Further sets of effects that are indistinguishable from the answer on these data, or differ from it by an effect
/// that is: their effects, without the answer's own, "name @ where".
std::vector<std::string> look_alikes_of(const SearchResult& found);

/// A set that says something else than the answer and its look-alikes, and by how much the answer is ahead of it.
struct OtherSet {
  const FittedModel* set = nullptr;  ///< of the search's; null: there is none
  double lead = 0.0;                 ///< standard errors, at most 10; negative where it gains more by more values
};

/// The one that is least behind.
OtherSet nearest_other(const SearchResult& found);

/// What a search shows of how sure its answer is, each figure by name and within a range (calibration.h).
Evidence evidence_of(const SearchResult& found);

}  // namespace lacuna
