#pragma once

#include "measurement/guesses/column_guess.h"

#include <vector>

namespace lacuna {

/// Finds columns of positions that are x and y of a tracked point, as video programs write them, if the points lie on a
/// circle on which they go to and fro or all the way round: x is then used for the angle (`track`), y not separately.
/// Without a unit they are assumed to be in m.
void settle_tracks(const FileSample& sample, std::vector<GuessedColumn>& columns);

}  // namespace lacuna
