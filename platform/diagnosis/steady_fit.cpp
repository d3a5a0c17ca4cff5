#include "diagnosis/steady_fit.h"

#include "diagnosis/integration_error.h"
#include "diagnosis/jackknife.h"

#include <cmath>
#include <numeric>

namespace lacuna {
namespace {

constexpr int kMostFits = 6;
constexpr double kStays = 0.1;  ///< standard errors
constexpr double kWorse = 4.0;  ///< of the deviance: what is taken off is no integrator's error then

bool stays(const Contender& model, const Refit& before, const Refit& after) {
  const ParameterSpace space(model.definition.free);
  const Eigen::VectorXd moved = space.to_coordinates(after.values) - space.to_coordinates(before.values);
  for (Eigen::Index j = 0; j < moved.size(); ++j)
    if (std::abs(moved(j)) > kStays * std::sqrt(after.covariance(j, j))) return false;
  return true;
}

Refit corrected(const Contender& model, const Round& last, const std::vector<Trial>& measured, int threads) {
  Refit fit = last.fit;
  std::vector<std::size_t> own_places(fit.values.size());
  std::iota(own_places.begin(), own_places.end(), std::size_t{0});
  for (int time = 0; time < kMostFits; ++time) {
    BaseSolution base = from(last.base, fit);
    base.trials = measured;
    base.values = fit.values;
    if (!correct_for_steps(model.definition, base, threads)) return fit;
    Refit again =
        refit({model.definition, *model.model, own_places}, base, last.bins, last.factors, {fit.values}, threads);
    if (!again.valid) return fit;
    if (again.deviance > last.fit.deviance + kWorse) return last.fit;
    const bool same = stays(model, fit, again);
    fit = std::move(again);
    if (same) return fit;
  }
  return fit;
}

}  // namespace

Refit steady_fit(const Contender& model, const Round& last, const std::vector<Trial>& measured, int threads) {
  Refit fit = corrected(model, last, measured, threads);
  fit.covariance = wary_covariance(fit, last.folds);
  return fit;
}

}  // namespace lacuna
