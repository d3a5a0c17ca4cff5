#include "diagnosis/rounds/unaided.h"

#include <utility>

namespace lacuna {

std::optional<Unaided> refit_unaided(const Contender& plain, const Round& round, std::uint64_t seed, int threads) {
  Refit fit = refit_under(round, plain, threads);
  if (!fit.valid) return std::nullopt;
  Eigen::VectorXd held_out = held_out_deviance(fit, round.folds);
  const Gain behind = gain(held_out, round.held_out, seed);
  return Unaided{std::move(fit), std::move(held_out), behind};
}

}  // namespace lacuna
