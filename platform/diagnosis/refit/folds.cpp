#include "diagnosis/refit/folds.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr double kTold = 1e-12;     ///< of the strongest direction's information
constexpr double kLeastKept = 0.2;  ///< of a direction's information, without a fold

std::size_t count_of(const Folds& folds) {
  std::size_t count = 1;
  for (const std::vector<std::size_t>& blocks : folds)
    for (const std::size_t fold : blocks) count = std::max(count, fold + 1);
  return count;
}

/// What is known of the values beforehand, which a fold leaves where it is.
WeightedSegment prior_of(const RobustSegment& segment) {
  const Eigen::Index rows = segment.priors_of_values;
  return {segment.residual.tail(rows), segment.values.bottomRows(rows), {}};
}

/// What the blocks of other folds say, and what is known beforehand.
void add_without(std::size_t fold, const RobustSegment& segment, Eigen::VectorXd weights,
                 const std::vector<std::size_t>& folds, NormalEquations& normal) {
  if (std::all_of(folds.begin(), folds.end(), [&](std::size_t other) { return other == fold; }))
    return normal.add(prior_of(segment));
  for (Eigen::Index row = 0; row < segment.bins(); ++row)
    if (folds[segment.block_of[static_cast<std::size_t>(row)]] == fold) weights(row) = 0.0;
  normal.add(weighted(segment, weights));
}

/// Directions that the data tell, each with information 1: values × directions.
Eigen::MatrixXd told(const Eigen::MatrixXd& gram) {
  const Eigen::VectorXd unit = gram.diagonal().unaryExpr(
      [](double information) { return information > 0.0 ? 1.0 / std::sqrt(information) : 0.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(unit.asDiagonal() * gram * unit.asDiagonal());
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < eigen.eigenvalues().size(); ++i)
    if (eigen.eigenvalues()(i) > kTold * eigen.eigenvalues().maxCoeff()) kept.push_back(i);
  return unit.asDiagonal() * Eigen::MatrixXd(eigen.eigenvectors()(Eigen::all, kept)) *
         eigen.eigenvalues()(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

Normals normals_of(const std::vector<RobustSegment>& segments, const std::vector<Eigen::VectorXd>& weights,
                   const Folds& folds) {
  const Eigen::Index values = segments.empty() ? 0 : segments.front().values.cols();
  const NormalEquations nothing = no_equations(values);
  Normals normals{nothing, std::vector<NormalEquations>(count_of(folds), nothing)};
  for (std::size_t k = 0; k < segments.size(); ++k) {
    NormalEquations whole = nothing;
    whole.add(weighted(segments[k], weights[k]));
    normals.all.add(whole);
    for (std::size_t fold = 0; fold < normals.without.size(); ++fold) {
      NormalEquations& without = normals.without[fold];
      if (std::find(folds[k].begin(), folds[k].end(), fold) != folds[k].end())
        add_without(fold, segments[k], weights[k], folds[k], without);
      else
        without.add(whole);
    }
  }
  return normals;
}

Eigen::MatrixXd least_kept(const Eigen::MatrixXd& all, const Eigen::MatrixXd& without) {
  const Eigen::MatrixXd directions = told(all);
  if (directions.cols() == 0) return without;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> kept(directions.transpose() * without * directions);
  const Eigen::VectorXd lacking = (kLeastKept - kept.eigenvalues().array()).cwiseMax(0.0);
  if (lacking.maxCoeff() == 0.0) return without;
  const Eigen::MatrixXd back = all * directions * kept.eigenvectors();
  return without + back * lacking.asDiagonal() * back.transpose();
}

Eigen::VectorXd minimum_without(const NormalEquations& all, const NormalEquations& without) {
  const Eigen::MatrixXd directions = told(all.gram);
  if (directions.cols() == 0) return Eigen::VectorXd::Zero(all.score.size());
  const Eigen::MatrixXd kept = directions.transpose() * least_kept(all.gram, without.gram) * directions;
  return -directions * kept.ldlt().solve(directions.transpose() * without.score);
}

Eigen::VectorXd held_out(const std::vector<RobustSegment>& segments, const Folds& folds,
                         const std::function<Eigen::VectorXd(std::size_t segment, std::size_t fold)>& residual) {
  std::vector<double> all;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    std::vector<double> blocks(folds[k].size(), 0.0);
    for (const std::size_t fold : std::set(folds[k].begin(), folds[k].end())) {
      const Eigen::VectorXd deviances = block_deviances(segments[k], residual(k, fold));
      for (std::size_t block = 0; block < blocks.size(); ++block)
        if (folds[k][block] == fold) blocks[block] = deviances(static_cast<Eigen::Index>(block));
    }
    all.insert(all.end(), blocks.begin(), blocks.end());
  }
  return Eigen::VectorXd::Map(all.data(), static_cast<Eigen::Index>(all.size()));
}

}  // namespace lacuna
