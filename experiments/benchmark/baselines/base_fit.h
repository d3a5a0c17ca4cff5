#pragma once

#include "baselines/observed.h"

namespace hidden_effects {

/// The base fitted by free run, its readings weighted by what it leaves of each sensor; the best of fits from several
/// values, for one alone may end in a wrong dip.
struct BaseFit {
  std::vector<double> deviations;  ///< by sensor, RMS of what is left, in its unit
  PlantFit fit;
};

/// Throws `std::runtime_error` where the base runs away.
BaseFit fit_base(const Observed& seen, const std::vector<Eigen::VectorXd>& beginnings);

/// Where a trial seems to begin: a line through the first 50 ms of each position.
Start first_start(const PlantSpec& spec, const FittedTrial& trial);

/// What a model predicts for all trials, whitened like the fit's residuals and with their order, one below the other.
/// Empty where the plant runs away.
Eigen::VectorXd whitened_prediction(const PlantModel& model, const Eigen::VectorXd& values,
                                    const std::vector<FittedTrial>& trials, const std::vector<Start>& starts,
                                    const std::vector<double>& deviations);

/// Orthonormal columns that span what the base's values and its starts can do to the whitened readings of all trials.
Eigen::MatrixXd base_directions(const Observed& seen, const BaseFit& base);

/// What is left of all trials, one below the other.
Eigen::VectorXd stacked(const std::vector<Eigen::VectorXd>& residuals);

}  // namespace hidden_effects
