#pragma once

#include <span>

namespace lacuna {

/// The step of a channel's quantiser (an encoder's count, a converter's bit, the last printed digit), in the channel's
/// unit; 0 if its values do not lie on a grid. NaNs do not count. Values of a grid that were printed with rounding are
/// recognised as long as the rounding is below a twentieth of the step. Deterministic; the cost is that of sorting.
double quantisation_step(std::span<const double> values);

}  // namespace lacuna
