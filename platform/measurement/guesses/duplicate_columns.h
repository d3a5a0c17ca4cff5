#pragma once

#include "measurement/guesses/column_guess.h"

#include <vector>

namespace lacuna {

/// Of columns that hold one quantity in several units (feet and metres, degrees and radians), leaves all but one out:
/// what they say in SI units is the same, to half a percent of its span. Kept is the column in SI units, else the
/// first.
void leave_out_duplicates(const FileSample& sample, std::vector<GuessedColumn>& columns);

}  // namespace lacuna
