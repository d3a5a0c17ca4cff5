#include "criterion/evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace lacuna {
namespace {

constexpr Eigen::Index kFewestForError = 3, kFewestForSigns = 5;
constexpr int kDraws = 999;

Eigen::VectorXd joined(const Eigen::VectorXd& blocks, Eigen::Index together) {
  Eigen::VectorXd sums((blocks.size() + together - 1) / together);
  for (Eigen::Index i = 0; i < sums.size(); ++i)
    sums(i) = blocks.segment(i * together, std::min(together, blocks.size() - i * together)).sum();
  return sums;
}

/// Of unit length; empty where nothing differs.
std::vector<Eigen::VectorXd> directions(const std::vector<Eigen::VectorXd>& gains, Eigen::Index together) {
  std::vector<Eigen::VectorXd> all;
  for (const Eigen::VectorXd& gain : gains) {
    Eigen::VectorXd sums = joined(gain, together);
    if (sums.squaredNorm() > 0.0) all.push_back(sums / sums.norm());
  }
  return all;
}

double probability(const std::vector<Eigen::VectorXd>& gains, std::uint64_t seed) {
  double observed = -1e300;
  for (const Eigen::VectorXd& gain : gains) observed = std::max(observed, gain.sum());
  std::mt19937_64 bits(seed);
  int reached = 0;
  Eigen::VectorXd signs(gains.front().size());
  for (int draw = 0; draw < kDraws; ++draw) {
    for (double& sign : signs) sign = (bits() >> 63U) != 0 ? 1.0 : -1.0;
    double largest = -1e300;
    for (const Eigen::VectorXd& gain : gains) largest = std::max(largest, gain.dot(signs));
    reached += largest >= observed ? 1 : 0;
  }
  return (1.0 + reached) / (1.0 + kDraws);
}

}  // namespace

double standard_error(const Eigen::VectorXd& by_block) {
  double largest = 0.0;
  for (const Eigen::Index together : kBlocksTogether) {
    const Eigen::VectorXd sums = joined(by_block, together);
    if (sums.size() < kFewestForError) continue;
    const auto count = static_cast<double>(sums.size());
    const double variance = (sums.array() - sums.mean()).square().sum() / (count - 1.0);
    largest = std::max(largest, std::sqrt(count * variance));
  }
  return largest;
}

double sign_probability(const std::vector<Eigen::VectorXd>& gains, std::uint64_t seed) {
  double worst = 0.0;
  for (const Eigen::Index together : kBlocksTogether) {
    const std::vector<Eigen::VectorXd> all = directions(gains, together);
    if (!all.empty() && all.front().size() >= kFewestForSigns) worst = std::max(worst, probability(all, seed));
  }
  return worst > 0.0 ? worst : 1.0;
}

}  // namespace lacuna
