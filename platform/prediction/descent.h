#pragma once

#include "prediction/linear_prediction.h"

namespace lacuna {

/// By stretch, what a unit of each unknown component of its start adds to the prediction, over the standard deviation
/// of a reading.
using StartDerivatives = std::vector<Eigen::MatrixXd>;

/// A model's values and starts where its cost is least, linearised there.
struct PredictionFit {
  bool valid = false;
  PredictionPoint point;
  BlockProducts products;
  StartDerivatives by_starts;
  StepBounds bounds;   ///< how far the values may move from here
  double cost = 0.0;   ///< nats, with what the way of the values from where they start costs
  int iterations = 0;  ///< steps tried
};

/// Gauss-Newton on the cost, damped, from `start`; every start of a stretch moves along with each step, which costs no
/// further simulation. `most`: steps. `like`: derivatives by starts of a like model on the same ladder, to begin with;
/// they are found anew once, where the steps end. Null: found at the start, too.
PredictionFit descend(LadderPredictions& predictions, const PredictionPoint& start, int most,
                      const StartDerivatives* like = nullptr);

}  // namespace lacuna
