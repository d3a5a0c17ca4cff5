#pragma once

#include "prediction/linear_prediction.h"

namespace lacuna {

/// By stretch, what a unit of each unknown component of its start, or of each value, adds to the prediction, over the
/// standard deviation of a reading.
using Derivatives = std::vector<Eigen::MatrixXd>;

/// Derivatives of a like model on the same ladder, to begin with.
struct LikeModel {
  Derivatives by_starts, by_values;
  std::vector<std::string> values = {};  ///< names of its values
  bool empty() const { return by_starts.empty(); }
};

/// A model's values and starts where its cost is least, linearised there.
struct PredictionFit {
  bool valid = false;
  PredictionPoint point;
  BlockProducts products;
  Derivatives by_starts, by_values;
  StepBounds bounds;   ///< how far the values may move from here
  double cost = 0.0;   ///< nats, with what the way of the values from where they start costs
  int iterations = 0;  ///< steps tried
};

/// Where the first steps end: with all derivatives found anew there, and more steps; or, to save simulations, with
/// those by values alone, and only where those of the like model led nowhere.
enum class LastSteps { anew, as_it_is };

/// Gauss-Newton on the cost, damped, from `start`; every start of a stretch moves along with each step, which costs no
/// further simulation. `most`: steps. `like`: derivatives that a like model has are taken from there; `names`: of the
/// values, by which its columns are known. Empty: all are found at the start.
PredictionFit descend(LadderPredictions& predictions, const PredictionPoint& start, int most,
                      const LikeModel& like = {}, const std::vector<std::string>& names = {},
                      LastSteps last = LastSteps::anew);

}  // namespace lacuna
