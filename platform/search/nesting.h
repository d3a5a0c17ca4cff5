#pragma once

#include "search/effect_search.h"

namespace lacuna {

inline constexpr double kNested = 1e-3;  ///< nats by which a set may cost more than its part

/// Counts the sets with a part that was fitted, too, and those of them that cost more than it.
void count_nesting(SearchResult& result);

}  // namespace lacuna
