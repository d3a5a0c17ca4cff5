#pragma once

#include "refit/plant_fit.h"

namespace hidden_effects {

/// A model with values, and the trials that it is asked about.
struct Question {
  const PlantModel& model;
  const Eigen::VectorXd& values;
  const std::vector<FittedTrial>& trials;
  const std::vector<Start>& starts;
  const Whiten& whiten;
  double step = kFitStep;  ///< s
};

/// Readings minus prediction, whitened, by trial; throws as `simulate` does.
std::vector<Eigen::VectorXd> whitened_residuals(const Question& question);

/// What small changes of a model's values and of the trials' starts do to the whitened predictions.
class Nuisances {
 public:
  explicit Nuisances(const Question& question);

  /// The same without the derivatives of the values from `first` on, `count` of them.
  Nuisances without(Eigen::Index first, Eigen::Index count) const;

  /// What neither starts nor values can explain of a whitened difference; trials one below the other.
  Eigen::VectorXd projected(const std::vector<Eigen::VectorXd>& by_trial) const;

  /// Of the values, the starts projected out.
  Eigen::MatrixXd information() const { return of_values_.transpose() * of_values_; }

 private:
  std::vector<Eigen::MatrixXd> start_basis_;  ///< orthonormal, by trial
  Eigen::MatrixXd of_values_;                 ///< starts projected out
  Eigen::MatrixXd value_basis_;               ///< orthonormal
};

/// Orthonormal columns that span those of `columns`, of lower rank where these depend on each other.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

}  // namespace hidden_effects
