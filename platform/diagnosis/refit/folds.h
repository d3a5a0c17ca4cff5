#pragma once

#include "diagnosis/noise/robust_segment.h"
#include "diagnosis/refit/normal_equations.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace lacuna {

/// By segment and block: which fold it belongs to.
using Folds = std::vector<std::vector<std::size_t>>;

struct Normals {
  NormalEquations all;
  std::vector<NormalEquations> without;  ///< each fold; where blocks of a segment stay, its start is told by these
};

/// `weights`: of each segment's rows.
Normals normals_of(const std::vector<RobustSegment>& segments, const std::vector<Eigen::VectorXd>& weights,
                   const Folds& folds);

/// What is told of the values without a fold, with at least a fifth of what all folds tell in every direction: where
/// the fold tells a direction nearly alone (a stop that is hit once), nobody would predict it from the others, and the
/// quadratic model of the deviance points to where it does not hold.
Eigen::MatrixXd least_kept(const Eigen::MatrixXd& all, const Eigen::MatrixXd& without);

/// The change of the values to where the deviance without a fold is least, with `least_kept` of it; nothing along
/// directions that no fold tells.
Eigen::VectorXd minimum_without(const NormalEquations& all, const NormalEquations& without);

/// Deviance of every block, one after the other, from the residual of its segment that its fold was left out of.
Eigen::VectorXd held_out(const std::vector<RobustSegment>& segments, const Folds& folds,
                         const std::function<Eigen::VectorXd(std::size_t segment, std::size_t fold)>& residual);

}  // namespace lacuna
