#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

namespace lacuna {

/// What a search says: verdict, ranking, errors, values, and sentences about them. No probability, no doubts.
Diagnosis findings_of(const SearchResult& found);

}  // namespace lacuna
