#pragma once

#include "foundation/text/encoding.h"

#include <vector>

namespace lacuna {

/// What the numbers of a column mean, in their order of time; NaN where one is missing. A counter that wraps is taken
/// to have gone the shorter way from one reading to the next.
void decode(const Encoding& encoding, std::vector<double>& column);

}  // namespace lacuna
