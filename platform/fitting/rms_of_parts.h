#pragma once

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// Root mean square over all rows of all parts; 0 without any.
double rms_of_parts(const std::vector<Eigen::VectorXd>& parts);

}  // namespace lacuna
