#include "baselines/effective_bic.h"

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

/// The sum of the autocorrelations of a residual that is positively correlated up to there.
double positive_sum(const Eigen::VectorXd& x) {
  const double squares = x.squaredNorm();
  double sum = 0.0;
  for (Eigen::Index lag = 1; lag < x.size() && squares > 0.0; ++lag) {
    const double product = x.head(x.size() - lag).dot(x.tail(x.size() - lag));
    if (product <= 0.0) break;
    sum += product / squares;
  }
  return sum;
}

/// One part a sensor and trial.
std::vector<Eigen::VectorXd> parts_of(const PlantFit& fit, std::size_t sensors) {
  std::vector<Eigen::VectorXd> parts;
  for (const Eigen::VectorXd& residual : fit.residuals) {
    const Eigen::Index rows = residual.size() / static_cast<Eigen::Index>(sensors);
    for (Eigen::Index s = 0; s < static_cast<Eigen::Index>(sensors); ++s)
      parts.emplace_back(residual.segment(s * rows, rows));
  }
  return parts;
}

}  // namespace

double effective_count(const std::vector<Eigen::VectorXd>& parts) {
  double count = 0.0;
  for (const Eigen::VectorXd& part : parts)
    count += static_cast<double>(part.size()) / (1.0 + 2.0 * positive_sum(part));
  return count;
}

BaselineAnswer by_effective_bic(const BaseFit& base, const std::vector<Candidate>& candidates,
                                const std::vector<CandidateFit>& fits, const std::vector<std::size_t>& order) {
  const PlantFit* best = &base.fit;
  for (const CandidateFit& one : fits)
    if (one.fit.deviance < best->deviance) best = &one.fit;
  const double n = effective_count(parts_of(*best, base.deviations.size()));
  std::vector<double> scores;
  for (const CandidateFit& one : fits) {
    const double more = static_cast<double>(one.fit.values.size() - base.fit.values.size());
    scores.push_back(0.5 * n * std::log(base.fit.deviance / one.fit.deviance) - 0.5 * more * std::log(n));
  }
  BaselineAnswer answer{"effective_bic", rank_fitted(candidates, fits, scores, order), 0, 0.0};
  answer.chosen = !fits.empty() && answer.ranking.front().score > 0.0 ? 1 : 0;
  return answer;
}

}  // namespace hidden_effects
