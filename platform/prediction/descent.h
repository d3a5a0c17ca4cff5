#pragma once

#include "prediction/linear_prediction.h"

namespace lacuna {

/// By stretch, the change of the prediction per unit of each unknown component of its start or of each value, over the
/// standard deviation of a reading.
using Derivatives = std::vector<Eigen::MatrixXd>;

/// Derivatives of a similar model on the same ladder, used first.
struct LikeModel {
  Derivatives by_starts, by_values;
  std::vector<std::string> values = {};  ///< names of its values
  bool empty() const { return by_starts.empty(); }
};

/// A model's values and initial states where its cost is smallest, linearised there.
struct PredictionFit {
  bool valid = false;
  PredictionPoint point;
  BlockProducts products;
  Derivatives by_starts, by_values;
  StepBounds bounds;   ///< how far the values may still move from here
  double cost = 0.0;   ///< nats, with the penalty for the distance of the values from their start
  int iterations = 0;  ///< steps tried
};

/// Where the first series of steps ends: computes all derivatives anew there and makes more steps; or, to save
/// simulations, recomputes only those by values, and makes more steps only where the derivatives of the similar model
/// led nowhere.
enum class LastSteps { anew, as_it_is };

/// Damped Gauss-Newton on the cost, from `start`; the initial state of every stretch moves with each step without
/// further simulations. `most`: steps. `like`: derivatives to take from a similar model; `names`: of the values, which
/// identify its columns. Empty: all derivatives are computed at the start.
PredictionFit descend(LadderPredictions& predictions, const PredictionPoint& start, int most,
                      const LikeModel& like = {}, const std::vector<std::string>& names = {},
                      LastSteps last = LastSteps::anew);

}  // namespace lacuna
