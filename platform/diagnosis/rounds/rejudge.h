#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/rounds/round.h"
#include "diagnosis/rounds/search_state.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace lacuna {

/// The rivals of a round, judged again under the noise that the round after it found with the chosen one in the model:
/// the noise of the first was estimated beside a model that lacks something, and close calls depend on it.
struct Rejudged {
  /// A rival that is better after all: ahead of the chosen one by more than its standard error and 2 nats, or simpler
  /// and no further behind than that or a tenth of the gain. A richer one must be ahead by a tenth of the gain, or by a
  /// hundredth and more than its interval and reach the noise floor where the simpler one stays clear of it (which also
  /// keeps a chosen one against a simpler that is not ahead), and be ahead of the chosen one together with any single
  /// effect of the next round, as long as the two have no more parameters. Parameters are those of the models; the
  /// timing of commands is none of these.
  std::optional<std::size_t> better;
  std::vector<double> values;  ///< of the better one's model, as refitted
  /// Rivals that these data do not tell from the chosen one, the closest first, refitted. Not a richer one that the
  /// data hold at the limit of its range, where it is no more than what a simpler one is.
  std::vector<std::pair<std::size_t, Refit>> inseparable;
};

/// What is judged again. Everything referred to must live until `rejudge` returns.
struct RejudgeTask {
  const SearchStep& before;
  const Contender& plain;  ///< the model without any effect added
  const PluginCatalog& catalog;
  const Round& now;  ///< of the model with the chosen rival
  std::uint64_t seed = 1;
  int threads = 1;
};

Rejudged rejudge(const RejudgeTask& task);

struct RefitAgain {
  Refit fit;
  bool at_limit = false;  ///< the data hold a value of its own effect at a bound
};

/// Those rivals of `before`, refitted under the noise of `now` from where they were.
std::vector<RefitAgain> refit_again(const RejudgeTask& task, const std::vector<std::size_t>& which);

}  // namespace lacuna
