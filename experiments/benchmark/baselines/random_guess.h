#pragma once

#include "baselines/answer.h"

#include <cstdint>

namespace hidden_effects {

/// The candidates in an order that a seed draws, each as likely first as any other. It always says that the first one
/// is there: what guessing is worth.
BaselineAnswer by_random_guess(const std::vector<Candidate>& candidates, std::uint64_t seed);

}  // namespace hidden_effects
