#include "diagnosis/refit/cross_validation.h"

#include "fitting/seeded_noise.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

constexpr std::size_t kFewTrials = 4;  ///< below, trials are divided
constexpr std::size_t kFolds = 8;
constexpr int kDraws = 999;

}  // namespace

Folds folds(const std::vector<Segment>& segments, const RowBins& bins) {
  std::vector<std::size_t> blocks;  // a segment
  std::map<std::size_t, std::size_t> sizes;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const std::vector<std::size_t> of_bins = bins.blocks(k);
    blocks.push_back(*std::max_element(of_bins.begin(), of_bins.end()) + 1);
    sizes[segments[k].stretch.trial] += blocks.back();
  }
  const std::size_t parts = sizes.size() >= kFewTrials ? 1 : (kFolds + sizes.size() - 1) / sizes.size();
  Folds all;
  std::map<std::size_t, std::size_t> seen;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const std::size_t trial = segments[k].stretch.trial;
    all.emplace_back();
    for (std::size_t block = 0; block < blocks[k]; ++block) {
      const std::size_t part = seen[trial]++ * parts / sizes[trial];
      all.back().push_back(numbers.try_emplace({trial, part}, numbers.size()).first->second);
    }
  }
  return all;
}

namespace {

/// Where the quadratic model of the deviance has its minimum without a fold, from where the fit is; of the values that
/// are `inside`.
Eigen::VectorXd step_to_minimum(const NormalEquations& all, const NormalEquations& without,
                                const std::vector<Eigen::Index>& inside) {
  Eigen::VectorXd step = Eigen::VectorXd::Zero(all.score.size());
  if (!inside.empty())
    step(inside) = minimum_without({all.gram(inside, inside), all.score(inside)},
                                   {without.gram(inside, inside), without.score(inside)});
  return step;
}

}  // namespace

std::vector<Eigen::VectorXd> steps_without(const Refit& fit, const Folds& folds) {
  const Eigen::Index count = fit.covariance.rows();
  std::vector<Eigen::Index> inside;
  for (Eigen::Index j = 0; j < count; ++j)
    if (!fit.at_bound[static_cast<std::size_t>(j)]) inside.push_back(j);
  std::vector<Eigen::VectorXd> weights;
  for (const RobustSegment& segment : fit.segments) weights.push_back(segment.weights(segment.residual));
  const Normals normals = normals_of(fit.segments, weights, folds);
  // Where a search was given up on its way, nobody knows whether it would have got where its derivatives point.
  const Eigen::VectorXd given_up =
      fit.converged ? Eigen::VectorXd::Zero(count) : step_to_minimum(normals.all, normals.all, inside);
  std::vector<Eigen::VectorXd> steps;
  for (const NormalEquations& without : normals.without)
    steps.emplace_back(step_to_minimum(normals.all, without, inside) - given_up);
  return steps;
}

Eigen::VectorXd held_out_deviance(const Refit& fit, const Folds& folds) {
  const std::vector<Eigen::VectorXd> steps = steps_without(fit, folds);
  return held_out(fit.segments, folds, [&](std::size_t k, std::size_t fold) -> Eigen::VectorXd {
    return fit.segments[k].residual + fit.segments[k].values * steps[fold];
  });
}

Gain gain(const Eigen::VectorXd& worse, const Eigen::VectorXd& better, std::uint64_t seed) {
  const Eigen::VectorXd differences = 0.5 * (worse - better);
  const Eigen::Index count = differences.size();
  std::vector<double> sums;
  SeededNoise random(seed, 0x6a17);
  for (int draw = 0; draw < kDraws; ++draw) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < count; ++i)
      sum += differences(std::min(count - 1, static_cast<Eigen::Index>(random.uniform() * static_cast<double>(count))));
    sums.push_back(sum);
  }
  std::sort(sums.begin(), sums.end());
  Gain result;
  result.value = differences.sum();
  const double mean = differences.mean();
  const double variance =
      count > 1 ? (differences.array() - mean).square().sum() / static_cast<double>(count - 1) : 0.0;
  result.standard_error = std::sqrt(variance * static_cast<double>(count));
  result.lower_95 = sums[static_cast<std::size_t>(0.025 * kDraws)];
  result.upper_95 = sums[static_cast<std::size_t>(0.975 * kDraws)];
  return result;
}

}  // namespace lacuna
