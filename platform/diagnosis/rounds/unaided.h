#pragma once

#include "diagnosis/rounds/round.h"

#include <optional>

namespace lacuna {

/// The model without any effect added, refitted under the noise of a round.
struct Unaided {
  Refit fit;
  Eigen::VectorXd held_out;  ///< deviance by block
  Gain behind;               ///< what the round's model gains over it
};

/// `plain`: with the values to start from. Nothing where it cannot be simulated.
std::optional<Unaided> refit_unaided(const Contender& plain, const Round& round, std::uint64_t seed, int threads);

}  // namespace lacuna
