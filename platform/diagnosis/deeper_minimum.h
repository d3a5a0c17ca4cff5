#pragma once

#include "diagnosis/round.h"

#include <optional>

namespace lacuna {

/// Whether the model of a round explains clearly more from where one of its best rivals ended, without that rival's
/// effect: then it was fitted to a minimum beside the deepest one, and what the rival gained over it is no sign of the
/// effect. The fit that was found there; nothing where the model is at its minimum.
std::optional<Refit> deeper_minimum(const Contender& model, const Round& round, int threads);

}  // namespace lacuna
