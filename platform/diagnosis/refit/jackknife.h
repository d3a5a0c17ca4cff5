#pragma once

#include "diagnosis/refit/cross_validation.h"

namespace lacuna {

/// The covariance of a fit's coordinates, each no less certain than blocks of data make it that are left out in turn
/// (the delete-a-group jackknife; blocks of series: H. R. Künsch, Annals of Statistics 17 (1989) 1217-1241). Where the
/// noise is as it is modelled both say the same; where a random force is stronger at times, or of another spectrum, the
/// blocks differ by more than the model of the noise lets them. Correlations stay those of the fit.
Eigen::MatrixXd wary_covariance(const Refit& fit, const Folds& folds);

}  // namespace lacuna
