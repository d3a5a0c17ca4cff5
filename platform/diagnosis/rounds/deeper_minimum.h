#pragma once

#include "diagnosis/rounds/round.h"

#include <optional>

namespace lacuna {

/// The fit of a round's model from where one of its best rivals ended, without that rival's effect, if it explains
/// clearly more than the round's own: then that had ended in a minimum beside the deepest one, and what the rival
/// gained over it is no sign of the effect. Nothing where the model is at its minimum.
std::optional<Refit> deeper_minimum(const Contender& model, const Round& round, int threads);

}  // namespace lacuna
