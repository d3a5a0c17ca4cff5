#pragma once

#include "refit/plant_model.h"

#include <functional>

namespace hidden_effects {

/// Turns the differences of a trial (sensors beside each other, samples × sensors) into numbers of unit variance.
using Whiten = std::function<Eigen::VectorXd(std::size_t trial, const Eigen::MatrixXd& differences)>;

/// Divides by a standard deviation, by sensor.
Whiten by_deviation(std::vector<double> deviations);

struct PlantFit {
  Eigen::VectorXd values;
  std::vector<Start> starts;               ///< by trial
  double deviance = 0.0;                   ///< sum of squares of what is left, whitened
  std::size_t rows = 0;                    ///< how many of these
  Eigen::MatrixXd information;             ///< of the values, with the starts projected out
  std::vector<Eigen::VectorXd> residuals;  ///< whitened, by trial
  bool valid = false;                      ///< false: the plant ran away wherever the fit began
  double rms() const;                      ///< of what is left, 1 for noise alone
};

struct FitOptions {
  int most_iterations = 12;
  double enough = 1e-3;  ///< of the deviance over rows, the change that ends a fit
  bool free_starts = true;
  double step = kFitStep;  ///< s, of the integration
  double settled = 0.0;    ///< a deviance below which nobody asks for less
  double hopeless = 0.0;   ///< ends a fit whose last iteration took less than this share off the deviance
  bool wants_information = true;
  Eigen::VectorXd lower{}, upper{};  ///< of the values; empty: none
};

/// Least squares by free run over whole trials (K. Levenberg, Quart. Appl. Math. 2 (1944) 164-168): the model's values
/// and where each trial begins.
PlantFit fit_plant(const PlantModel& model, const std::vector<FittedTrial>& trials, const Eigen::VectorXd& values,
                   std::vector<Start> starts, const Whiten& whiten, const FitOptions& options = {});

}  // namespace hidden_effects
