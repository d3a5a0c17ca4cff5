#pragma once

#include "figures/figure_values.h"
#include "runs/database.h"

#include <filesystem>

namespace hidden_effects {

/// reliability.svg (stated probability against the share that is right, in ten bins), accuracy.svg (how many of the
/// verdicts are right among the surest ones) and confusion.svg (hidden effect and what was named first) in `folder`.
/// Throws `std::runtime_error` where one cannot be drawn.
void draw_pictures(const Database& database, const FigureValues& all, const std::filesystem::path& folder);

}  // namespace hidden_effects
