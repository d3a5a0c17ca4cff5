#include "search/nesting.h"

#include <algorithm>

namespace lacuna {

void count_nesting(SearchResult& result) {
  result.nested = result.unnested = 0;
  for (const FittedModel& set : result.sets)
    for (const FittedModel& part : result.sets) {
      const auto &whole = set.judged.members, &some = part.judged.members;
      if (some.size() >= whole.size() || !std::includes(whole.begin(), whole.end(), some.begin(), some.end())) continue;
      ++result.nested;
      if (set.fit.cost > part.fit.cost + kNested) ++result.unnested;
    }
}

}  // namespace lacuna
