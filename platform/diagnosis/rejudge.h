#pragma once

#include "diagnosis/round.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace lacuna {

/// The rivals of a round, judged again under the noise that the round after it found with the chosen one in the model:
/// the noise of the first was estimated beside a model that lacks something, and close calls depend on it.
struct Rejudged {
  /// A rival that is better after all: ahead of the chosen one by more than its standard error, or no further behind
  /// and simpler.
  std::optional<std::size_t> better;
  /// Rivals that these data do not tell from the chosen one, the closest first, refitted.
  std::vector<std::pair<std::size_t, Refit>> inseparable;
};

/// `now`: the round of `before`'s model with rival `chosen` added.
Rejudged rejudge(const Round& before, std::size_t chosen, const Round& now, std::uint64_t seed, int threads);

}  // namespace lacuna
