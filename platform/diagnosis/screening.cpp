#include "diagnosis/screening.h"

#include "diagnosis/last_digits.h"
#include "fitting/seeded_noise.h"

#include <Eigen/Eigenvalues>

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
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> covariance(directions.unit.transpose() * directions.unit);
  const Eigen::MatrixXd factor =
      covariance.eigenvectors() * covariance.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  SeededNoise random(seed, 0x5c0e);
  Eigen::MatrixXd noise(factor.cols(), static_cast<Eigen::Index>(kNullDraws));
  for (double& value : noise.reshaped()) value = random.normal();
  const Eigen::MatrixXd z = factor * noise;
  std::vector<double> largest(kNullDraws, 0.0);
  for (Eigen::Index draw = 0; draw < z.cols(); ++draw)
    for (Eigen::Index i = 0; i < z.rows(); ++i) {
      double& most = largest[static_cast<std::size_t>(draw)];
      most = std::max(most, deviance(z(i, draw), directions.one_sided[static_cast<std::size_t>(i)]));
    }
  std::sort(largest.begin(), largest.end());
  return largest;
}

}  // namespace

Screening screen(const WhitenedSegments& whitened, const std::vector<std::vector<Probe>>& probes, std::uint64_t seed) {
  Screening result;
  Directions directions;
  std::vector<Eigen::VectorXd> units;
  for (std::size_t h = 0; h < probes.size(); ++h)
    for (std::size_t p = 0; p < probes[h].size(); ++p) {
      const std::vector<Eigen::MatrixXd> column(probes[h][p].response.begin(), probes[h][p].response.end());
      const double power = whitened.whiten(column).squaredNorm();
      const Eigen::VectorXd left = whitened.project(column);
      const double norm = left.norm();
      ProbeScore score{h, p, 0.0, 0.0, power > 0.0 ? norm * norm / power : 0.0, norm * norm};
      if (score.seen < kSeen || !std::isfinite(norm)) continue;
      units.push_back(left / norm);
      directions.one_sided.push_back(probes[h][p].one_sided);
      const double z = units.back().dot(whitened.residual());
      score.deviance = deviance(z, probes[h][p].one_sided);
      score.size = z / norm;
      result.scores.push_back(score);
    }
  if (units.empty()) return result;
  directions.unit.resize(whitened.rows(), static_cast<Eigen::Index>(units.size()));
  for (std::size_t i = 0; i < units.size(); ++i) directions.unit.col(static_cast<Eigen::Index>(i)) = units[i];
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
