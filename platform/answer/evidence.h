#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

namespace lacuna {

/// Further sets of effects that are indistinguishable from the answer on these data, or differ from it by an effect
/// that is: their effects, without the answer's own, "name @ where".
std::vector<std::string> look_alikes_of(const SearchResult& found);

/// What a search shows of how sure its answer is, each figure by name and within a range (calibration.h).
Evidence evidence_of(const SearchResult& found);

}  // namespace lacuna
