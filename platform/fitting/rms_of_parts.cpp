#include "fitting/rms_of_parts.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

double rms_of_parts(const std::vector<Eigen::VectorXd>& parts) {
  double squares = 0.0, count = 0.0;
  for (const Eigen::VectorXd& part : parts) {
    squares += part.squaredNorm();
    count += static_cast<double>(part.size());
  }
  return std::sqrt(squares / std::max(count, 1.0));
}

}  // namespace lacuna
