#pragma once

#include "foundation/text/encoding.h"

#include <vector>

namespace lacuna {

/// The meaning of a column's numbers, in their order of time; NaN where one is missing. A counter that wraps is assumed
/// to take the shorter way from one reading to the next.
void decode(const Encoding& encoding, std::vector<double>& column);

}  // namespace lacuna
