#include "diagnosis/cross_validation.h"

#include "fitting/seeded_noise.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

constexpr std::size_t kFewTrials = 4;  ///< below, trials are divided
constexpr std::size_t kFolds = 8;
constexpr int kDraws = 999;

}  // namespace

std::vector<std::size_t> folds(const std::vector<Segment>& segments) {
  std::map<std::size_t, std::size_t> sizes;
  for (const Segment& segment : segments) ++sizes[segment.stretch.trial];
  const std::size_t parts = sizes.size() >= kFewTrials ? 1 : (kFolds + sizes.size() - 1) / sizes.size();
  std::vector<std::size_t> fold;
  std::map<std::size_t, std::size_t> seen;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
  for (const Segment& segment : segments) {
    const std::size_t trial = segment.stretch.trial;
    const std::size_t part = seen[trial]++ * parts / sizes[trial];
    fold.push_back(numbers.try_emplace({trial, part}, numbers.size()).first->second);
  }
  return fold;
}

namespace {

/// Where the quadratic model of the deviance has its minimum, from where the fit is; of the values that are `inside`.
Eigen::VectorXd step_to_minimum(const Eigen::MatrixXd& information, const Eigen::VectorXd& score,
                                const std::vector<Eigen::Index>& inside) {
  Eigen::VectorXd step = Eigen::VectorXd::Zero(score.size());
  if (inside.empty()) return step;
  const Eigen::MatrixXd own = information(inside, inside);
  step(inside) = -Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(own).solve(Eigen::VectorXd(score(inside)));
  return step;
}

}  // namespace

std::vector<Eigen::VectorXd> steps_without(const Refit& fit, const std::vector<std::size_t>& folds) {
  const Eigen::Index count = fit.covariance.rows();
  std::vector<Eigen::Index> inside;
  for (Eigen::Index j = 0; j < count; ++j)
    if (!fit.at_bound[static_cast<std::size_t>(j)]) inside.push_back(j);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd score = Eigen::VectorXd::Zero(count);
  const std::size_t last = folds.empty() ? 0 : *std::max_element(folds.begin(), folds.end());
  std::vector<Eigen::MatrixXd> fold_information(last + 1, information);
  std::vector<Eigen::VectorXd> fold_score(last + 1, score);
  for (std::size_t k = 0; k < folds.size(); ++k) {
    fold_information[folds[k]] += fit.weighted[k].values.transpose() * fit.weighted[k].values;
    fold_score[folds[k]] += fit.weighted[k].values.transpose() * fit.weighted[k].residual;
  }
  for (std::size_t f = 0; f <= last; ++f) {
    information += fold_information[f];
    score += fold_score[f];
  }
  // Where a search was given up on its way, nobody knows whether it would have got where its derivatives point.
  const Eigen::VectorXd given_up =
      fit.converged ? Eigen::VectorXd::Zero(count) : step_to_minimum(information, score, inside);
  std::vector<Eigen::VectorXd> steps;
  for (std::size_t f = 0; f <= last; ++f)
    steps.emplace_back(step_to_minimum(information - fold_information[f], score - fold_score[f], inside) - given_up);
  return steps;
}

Eigen::VectorXd held_out_deviance(const Refit& fit, const std::vector<std::size_t>& folds) {
  const std::vector<Eigen::VectorXd> steps = steps_without(fit, folds);
  Eigen::VectorXd deviance(static_cast<Eigen::Index>(folds.size()));
  for (std::size_t k = 0; k < folds.size(); ++k) {
    const RobustSegment& segment = fit.segments[k];
    deviance(static_cast<Eigen::Index>(k)) =
        robust_deviance(segment, segment.residual + segment.values * steps[folds[k]]);
  }
  return deviance;
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
