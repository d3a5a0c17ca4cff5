#pragma once

#include "figures/figure_values.h"
#include "runs/database.h"

#include <string>

namespace hidden_effects {

/// What other methods make of the same cases, as Markdown: a line a method, with its figures over all noise and for
/// disturbed data. Empty where none was run.
std::string baseline_table(const Database& database, const FigureValues& all);

}  // namespace hidden_effects
