#pragma once

#include "measurement/guesses/column_guess.h"

#include <vector>

namespace lacuna {

/// Finds columns of positions that are x and y of a tracked point, as programs for videos write them, and whose points
/// lie on a circle on which they go to and fro or all the way round: x stands for the angle then (`track`), y is not
/// needed by itself. Without a unit they are taken to be in m.
void settle_tracks(const FileSample& sample, std::vector<GuessedColumn>& columns);

}  // namespace lacuna
