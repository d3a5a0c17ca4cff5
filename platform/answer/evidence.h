#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

namespace lacuna {

/// Effects of other sets that are indistinguishable from the answer on these data, or from which they differ by one
/// such effect; without the answer's own effects; "name @ where".
std::vector<std::string> look_alikes_of(const SearchResult& found);

/// The set with another meaning than the answer, and the answer's lead over it.
struct OtherSet {
  const FittedModel* set = nullptr;  ///< one of the sets of the search; null: there is none
  double lead = 0.0;  ///< standard errors, at most 10; negative where the other set gains more with more values
};

/// The closest of them.
OtherSet nearest_other(const SearchResult& found);

/// The figures that show how sure an answer is, each by name and within a range (calibration.h).
Evidence evidence_of(const SearchResult& found);

}  // namespace lacuna
