#pragma once

#include "criterion/cost.h"
#include "fitting/shooting/parameter_space.h"
#include "prediction/prediction_ladder.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace lacuna {

/// A model's values and where each stretch starts.
struct PredictionPoint {
  Eigen::VectorXd values;               ///< coordinates of the parameter space
  std::vector<Eigen::VectorXd> starts;  ///< by stretch: its unknown components, SI
};

/// Residuals of a stretch and what changes them, over the standard deviation of a reading.
struct LinearStretch {
  Eigen::VectorXd residual;  ///< measured minus predicted, as it would be, to first order, from the smoothed start
  Eigen::MatrixXd values;    ///< what a unit of each value adds to the prediction
  Eigen::MatrixXd start;     ///< the same of each unknown component of the start
};

/// A model linearised at a point.
struct LinearPrediction {
  std::vector<LinearStretch> stretches;
  BlockProducts products;  ///< whitened by R + J P Jᵀ of each stretch and channel
};

/// Predictions of one model over a ladder. Simulations run in parallel over stretches; the digits do not depend on
/// threads.
class LadderPredictions {
 public:
  /// `changes_readings`: the model has effects or free values of sensors; starts are then those whose readings are as
  /// smoothed.
  LadderPredictions(const PredictionLadder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                    const SmoothedStarts& starts, bool changes_readings = false);

  const PredictionLadder& ladder() const { return ladder_; }
  const ParameterSpace& space() const { return space_; }
  bool fits_timing() const { return predictor_.fits_timing(); }
  /// Every stretch at its smoothed start.
  PredictionPoint at_smoothed_starts(const Eigen::VectorXd& values) const;
  /// By stretch, measured minus predicted over a reading's standard deviation; false where one cannot be simulated.
  bool residuals(const PredictionPoint& point, std::vector<Eigen::VectorXd>& residuals);
  /// Takes the residuals at a point, with the derivatives by starts as they are and none by values.
  bool residuals_at(const PredictionPoint& point, std::vector<LinearStretch>& stretches);
  /// The same with residuals that are known.
  void put_residuals(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                     std::vector<LinearStretch>& stretches) const;
  /// From now on differences of values are over ways that are found anew, unless they were taken.
  void forget_steps();
  /// From now on differences of values are over the ways that were right for the same model on another ladder.
  void take_steps_of(const LadderPredictions& other);
  /// Nothing where the point cannot be simulated.
  std::optional<LinearPrediction> linearise(const PredictionPoint& point);
  /// Where the residuals are known, by values alone: the derivatives by starts stay what they are in `linear`, and so
  /// do those by values that `stays` names.
  void linearise_values(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                        LinearPrediction& linear, const std::vector<bool>& stays = {});
  /// By starts alone, at the point where `linear` was taken by values.
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
  const SmoothedStarts* changed_readings_ = nullptr;  ///< by which starts follow the model's sensors; null: they do not
  std::vector<std::optional<WarmUp>> warm_ups_;       ///< by stretch
  std::vector<double> steps_, first_steps_;           ///< by value, in coordinates
  std::vector<char> is_steady_;                       ///< by value: whether it has a derivative
  std::vector<double> step_is_for_;                   ///< by value: size of the residuals; 0: to be found
  bool steps_are_taken_ = false;
  std::vector<std::size_t> all_, few_;   ///< stretches
  std::vector<Prediction> predictions_;  ///< by worker
  std::uint64_t simulations_ = 0;
  std::string failure_;
};

/// How each start moves where the values take a step: (P⁻¹ + JᵀJ)⁻¹ Jᵀ times what is left.
std::vector<Eigen::VectorXd> moved_starts(const PredictionLadder& ladder, const LinearPrediction& linear,
                                          const Eigen::VectorXd& step);

}  // namespace lacuna
