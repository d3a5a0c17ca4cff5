#pragma once

#include "criterion/cost.h"
#include "fitting/shooting/parameter_space.h"
#include "prediction/prediction_ladder.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace lacuna {

/// A model's values and the initial state of each stretch.
struct PredictionPoint {
  Eigen::VectorXd values;               ///< coordinates of the parameter space
  std::vector<Eigen::VectorXd> starts;  ///< by stretch: its unknown components, SI
};

/// Residuals of a stretch and their derivatives, over the standard deviation of a reading.
struct LinearStretch {
  Eigen::VectorXd residual;  ///< measured minus predicted, extrapolated to first order to the smoothed start
  Eigen::MatrixXd values;    ///< change of the prediction per unit of each value
  Eigen::MatrixXd start;     ///< the same for each unknown component of the start
};

/// A model linearised at a point.
struct LinearPrediction {
  std::vector<LinearStretch> stretches;
  BlockProducts products;  ///< whitened by R + J P Jᵀ of each stretch and channel
};

/// Predictions of one model over a ladder. Simulations run in parallel over stretches; the digits do not depend on the
/// number of threads.
class LadderPredictions {
 public:
  /// `changes_readings`: the model has effects or free values of sensors; its initial states are then chosen so that
  /// their readings agree with the smoothed ones.
  LadderPredictions(const PredictionLadder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                    const SmoothedStarts& starts, bool changes_readings = false);

  const PredictionLadder& ladder() const { return ladder_; }
  const ParameterSpace& space() const { return space_; }
  bool fits_timing() const { return predictor_.fits_timing(); }
  /// The point with every stretch at its smoothed start.
  PredictionPoint at_smoothed_starts(const Eigen::VectorXd& values) const;
  /// By stretch, measured minus predicted over a reading's standard deviation; false where a stretch cannot be
  /// simulated.
  bool residuals(const PredictionPoint& point, std::vector<Eigen::VectorXd>& residuals);
  /// Computes the residuals at a point; keeps the derivatives by initial states and discards those by values.
  bool residuals_at(const PredictionPoint& point, std::vector<LinearStretch>& stretches);
  /// The same with known residuals.
  void put_residuals(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                     std::vector<LinearStretch>& stretches) const;
  /// From now on the steps of values are chosen anew, unless they were taken over.
  void forget_steps();
  /// From now on values use the steps that were chosen for the same model on another ladder.
  void take_steps_of(const LadderPredictions& other);
  /// Nothing where the point cannot be simulated.
  std::optional<LinearPrediction> linearise(const PredictionPoint& point);
  /// At known residuals, by values alone: keeps the derivatives by initial states in `linear`, and those by values for
  /// which `stays` is set.
  void linearise_values(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                        LinearPrediction& linear, const std::vector<bool>& stays = {});
  /// By initial states alone, at the point where `linear` was computed by values.
  void linearise_starts(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                        LinearPrediction& linear);
  std::uint64_t simulations() const { return simulations_; }
  const std::string& failure() const { return failure_; }

 private:
  bool simulate(std::size_t k, const Eigen::VectorXd& values, const Eigen::VectorXd& start, int worker,
                Eigen::VectorXd& residual);
  bool residuals_of(const Eigen::VectorXd& values, const std::vector<Eigen::VectorXd>& starts,
                    const std::vector<std::size_t>& which, std::vector<Eigen::VectorXd>& residuals);
  double size_on_few(const std::vector<Eigen::VectorXd>& residuals) const;
  bool choose_step(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals, Eigen::Index j);
  void difference_value(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals, Eigen::Index j,
                        std::vector<LinearStretch>& stretches);
  void difference_starts(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                         std::vector<LinearStretch>& stretches);

  const PredictionLadder& ladder_;
  const TrialPredictor& predictor_;
  const ParameterSpace& space_;
  /// Used to adapt initial states to the model's sensors; null: not adapted.
  const SmoothedStarts* changed_readings_ = nullptr;
  std::vector<std::optional<WarmUp>> warm_ups_;  ///< by stretch
  std::vector<double> steps_, first_steps_;      ///< by value, step in coordinates
  std::vector<char> is_steady_;                  ///< by value: whether it has a derivative
  std::vector<double> step_is_for_;  ///< by value: size of the residuals at the choice of the step; 0: to be chosen
  bool steps_are_taken_ = false;
  std::vector<std::size_t> all_, few_;   ///< stretches
  std::vector<Prediction> predictions_;  ///< by worker
  std::uint64_t simulations_ = 0;
  std::string failure_;
};

/// The move of each initial state for a step of the values: (P⁻¹ + JᵀJ)⁻¹ Jᵀ times the remaining residual.
std::vector<Eigen::VectorXd> moved_starts(const PredictionLadder& ladder, const LinearPrediction& linear,
                                          const Eigen::VectorXd& step);

}  // namespace lacuna
