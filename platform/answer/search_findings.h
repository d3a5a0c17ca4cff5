#pragma once

#include "answer/diagnosis.h"
#include "search/effect_search.h"

namespace lacuna {

/// The findings of a search: verdict, ranking, errors, values, and sentences about them. Without probability and data
/// checks.
Diagnosis findings_of(const SearchResult& found);

}  // namespace lacuna
