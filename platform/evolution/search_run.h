#pragma once

#include <lacuna/search_strategy.h>

#include "foundation/processes/guarded_call.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

/// One score a genome, smaller is better, infinite: invalid. An evaluation that is certain to end above `bar` may be
/// answered with any number above it.
using ScoreGenomes =
    std::function<std::vector<double>(const std::vector<Individual>& individuals, std::optional<double> bar)>;

/// Runs a search to its end, generation by generation; `generation_done` is called after each and may throw to end it
/// early. What the search's plugin throws becomes an `Error` that names it.
void run_search(Search& search, const ComponentOrigin& origin, const ScoreGenomes& score,
                const std::function<void()>& generation_done);

}  // namespace lacuna
