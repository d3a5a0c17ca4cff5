#pragma once

#include "prediction/linear_prediction.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// A change of a prediction, by stretch, over the standard deviation of a reading.
using PredictedChange = std::vector<Eigen::VectorXd>;

/// A linearised model, whitened once by R + J P Jᵀ of each stretch and channel, for repeated addition of further
/// changes to its predictions. Const and shared by threads.
class WhitenedColumns {
 public:
  WhitenedColumns(const PredictionLadder& ladder, const std::vector<LinearStretch>& stretches);

  /// Products of the rows, in units of R, of the residual, the values and these changes: each column after the best
  /// start is removed, plus the cost of that start.
  BlockProducts with(const std::vector<const PredictedChange*>& changes) const;

 private:
  /// Rows of one channel in a stretch; in whitened form, followed by rows for the cost of the start.
  struct Part {
    std::size_t stretch = 0, cell = 0;
    std::vector<Eigen::Index> rows;   ///< of the stretch
    std::vector<std::size_t> blocks;  ///< by row
    Eigen::MatrixXd by_start;         ///< change per standard deviation of each unknown component of the start
    Eigen::LDLT<Eigen::MatrixXd> normal;
    Eigen::MatrixXd root;   ///< upper factor of the precision
    Eigen::MatrixXd known;  ///< residual and values, whitened
  };

  static Eigen::MatrixXd whitened(const Part& part, const Eigen::MatrixXd& columns);
  static void add_products(const Part& part, const Eigen::MatrixXd& columns, BlockProducts& products);

  CellLayout layout_;
  Eigen::Index values_ = 0;
  std::vector<Part> parts_;
};

/// Of the residual and the values alone.
BlockProducts whitened_products(const PredictionLadder& ladder, const std::vector<LinearStretch>& stretches);

}  // namespace lacuna
