#include "fitting/free_run.h"

#include "fitting/scores.h"

#include <cmath>

namespace lacuna {

FreeRun free_run(const TrialPredictor& predictor, const StartStates& states, std::size_t trial,
                 std::span<const double> values, int worker) {
  const Stretch whole = predictor.whole(trial);
  FreeRun run;
  run.start = fit_head(predictor, states, whole, values, worker);
  run.first_scored = first_scored(predictor, whole, run.start);
  predictor.predict(whole, values, run.start.start, worker, run.prediction);
  return run;
}

Eigen::VectorXd effect_of_start(const TrialPredictor& predictor, std::size_t trial, std::span<const double> values,
                                const FreeRun& run, int worker) {
  const Stretch whole = predictor.whole(trial);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(run.prediction.samples.cols());
  Prediction moved;
  for (Eigen::Index axis = 0; axis < run.start.axes.cols(); ++axis) {
    if (run.start.axes.col(axis).isZero(0.0)) continue;
    predictor.predict(whole, values, moved_along(run.start, axis), worker, moved);
    if (!moved.valid) continue;
    const TimeSeries::Samples change = moved.samples - run.prediction.samples;
    for (Eigen::Index c = 0; c < squares.size(); ++c)
      squares(c) += std::pow(scored_rms(change, c, run.first_scored), 2);
  }
  return squares.cwiseSqrt();
}

}  // namespace lacuna
