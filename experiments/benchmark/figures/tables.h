#pragma once

#include "figures/figure_values.h"

#include <string>

namespace hidden_effects {

/// "93.1 % [89.8, 95.4] n 120" of a share, "0.41 [0.38, 0.45] n 80" of anything else; "–" without a case.
std::string estimate_text(const FigureKind& figure, const Estimate& estimate);

/// "≥ 95 %", "3–7 %", "≤ 1.5"; empty without a goal.
std::string goal_text(const FigureKind& figure);

/// The figures as Markdown: by noise with the goals (which are for disturbed data), then by strength for each noise, by
/// rig, and by effect.
std::string markdown(const FigureValues& all);

}  // namespace hidden_effects
