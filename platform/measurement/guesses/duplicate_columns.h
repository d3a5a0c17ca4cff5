#pragma once

#include "measurement/guesses/column_guess.h"

#include <vector>

namespace lacuna {

/// Of columns with one quantity in several units (feet and metres, degrees and radians), keeps one: their values in SI
/// units agree to half a percent of the range. Keeps the column in SI units, else the first.
void leave_out_duplicates(const FileSample& sample, std::vector<GuessedColumn>& columns);

}  // namespace lacuna
