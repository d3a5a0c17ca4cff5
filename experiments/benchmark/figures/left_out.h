#pragma once

#include "figures/figure_values.h"

namespace hidden_effects {

/// Adds what the shipped calibration, fitted without the rig of a case, says of the case's verdict: the figures
/// `brier_left_out`, `calibration_left_out` and `calibration_by_chance`. Rigs that it does not know by name were all
/// left out.
void add_left_out(const Database& database, FigureValues& all);

}  // namespace hidden_effects
