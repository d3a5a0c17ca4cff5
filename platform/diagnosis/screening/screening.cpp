#include "diagnosis/screening/screening.h"

#include "diagnosis/noise/last_digits.h"
#include "fitting/seeded_noise.h"
#include "kernels/dense.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSeen = 1e-4;  ///< a smaller share of a response's power is rounding

/// The probes' directions, each of length 1, and which of them have a sign.
struct Directions {
  Eigen::MatrixXd unit;  ///< rows × probes
  std::vector<bool> one_sided;
};

double deviance(double z, bool one_sided) { return one_sided && z < 0.0 ? 0.0 : z * z; }

/// The largest deviance under noise alone. The z of all probes are drawn at once: normal, with the products of the
/// directions as their covariance.
std::vector<double> largest_by_chance(const Directions& directions, std::uint64_t seed) {
  // Not a triangular factor: of directions that nearly follow from each other it divides rounding by rounding.
  const dense::Eigenvectors covariance(dense::square(directions.unit.transpose()));
  const Eigen::MatrixXd factor = covariance.vectors * covariance.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  SeededNoise random(seed, 0x5c0e);
  Eigen::MatrixXd noise(factor.cols(), static_cast<Eigen::Index>(kNullDraws));
  for (double& value : noise.reshaped()) value = random.normal();
  const Eigen::MatrixXd z = dense::product(factor, noise);
  std::vector<double> largest(kNullDraws, 0.0);
  for (Eigen::Index draw = 0; draw < z.cols(); ++draw)
    for (Eigen::Index i = 0; i < z.rows(); ++i) {
      double& most = largest[static_cast<std::size_t>(draw)];
      most = std::max(most, deviance(z(i, draw), directions.one_sided[static_cast<std::size_t>(i)]));
    }
  std::sort(largest.begin(), largest.end());
  return largest;
}

/// Responses of all probes of all hypotheses: by segment, bins × probes.
std::vector<Eigen::MatrixXd> responses_of(const std::vector<std::vector<Probe>>& probes) {
  std::vector<const Probe*> all;
  for (const std::vector<Probe>& one : probes)
    for (const Probe& probe : one) all.push_back(&probe);
  std::vector<Eigen::MatrixXd> responses(all.empty() ? 0 : all.front()->response.size());
  for (std::size_t k = 0; k < responses.size(); ++k) {
    responses[k].resize(all.front()->response[k].size(), static_cast<Eigen::Index>(all.size()));
    for (std::size_t p = 0; p < all.size(); ++p) responses[k].col(static_cast<Eigen::Index>(p)) = all[p]->response[k];
  }
  return responses;
}

}  // namespace

Screening screen(const WhitenedSegments& whitened, const std::vector<std::vector<Probe>>& probes, std::uint64_t seed) {
  Screening result;
  const std::vector<Eigen::MatrixXd> responses = responses_of(probes);
  if (responses.empty()) return result;
  const Eigen::MatrixXd white = whitened.whiten(responses);
  Directions directions{whitened.beside_values(white), {}};
  Eigen::Index column = 0, kept = 0;
  for (std::size_t h = 0; h < probes.size(); ++h)
    for (std::size_t p = 0; p < probes[h].size(); ++p, ++column) {
      const double power = white.col(column).squaredNorm(), norm = directions.unit.col(column).norm();
      ProbeScore score{h, p, 0.0, 0.0, power > 0.0 ? norm * norm / power : 0.0, norm * norm};
      if (score.seen < kSeen || !std::isfinite(norm)) continue;
      directions.unit.col(kept) = directions.unit.col(column) / norm;
      directions.one_sided.push_back(probes[h][p].one_sided);
      const double z = directions.unit.col(kept++).dot(whitened.residual());
      score.deviance = deviance(z, probes[h][p].one_sided);
      score.size = z / norm;
      result.scores.push_back(score);
    }
  if (kept == 0) return result;
  directions.unit.conservativeResize(Eigen::NoChange, kept);
  const std::vector<double> chance = largest_by_chance(directions, seed);
  std::stable_sort(result.scores.begin(), result.scores.end(),
                   [](const ProbeScore& a, const ProbeScore& b) { return a.deviance > b.deviance; });
  result.chance_95 = chance[static_cast<std::size_t>(0.95 * kNullDraws)];
  const auto p = [&](double deviance) {
    const auto reached = chance.end() - std::lower_bound(chance.begin(), chance.end(), deviance);
    return (1.0 + static_cast<double>(reached)) / (1.0 + kNullDraws);
  };
  const double best = result.scores.front().deviance;
  result.p = p(best);
  result.p_low = p(best * (1.0 + kLastDigitsOfScore));
  result.p_high = p(best * (1.0 - kLastDigitsOfScore));
  return result;
}

}  // namespace lacuna
