#pragma once

#include "search/look.h"
#include "search/model_set.h"

namespace lacuna {

/// What a search looked through.
struct SearchedLibrary {
  bool stopped = false;        ///< by the time limit, which is lifted
  std::size_t hypotheses = 0;  ///< effect × place
  std::vector<Untestable> untestable;
};

/// Fits sets of effects: the most promising of the library alone, two at a time, and beside the best of those; to few
/// segments first, the best to all. Throws `Interrupted`.
SearchedLibrary search_sets(const Ground& ground, ModelSets& sets);

/// How many times as many sets are fitted as to a usual recording of a robot with few coordinates.
double breadth_of(const Ground& ground);

}  // namespace lacuna
