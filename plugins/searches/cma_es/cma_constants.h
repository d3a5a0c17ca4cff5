#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace lacuna {

/// The constants of Hansen's tutorial (2016), table 1, for n genes and a population, with its symbols.
struct CmaConstants {
  Eigen::VectorXd weights;  ///< of the best half, best first; their sum is 1
  double mu_eff;            ///< variance-effective size of the better half
  double c_sigma, d_sigma;  ///< step size
  double c_c, c_1, c_mu;    ///< covariance
  double chi_n;             ///< expected length of a normal vector

  CmaConstants(std::size_t genes, std::size_t population) {
    const auto n = static_cast<double>(genes);
    const auto mu = static_cast<Eigen::Index>(population / 2);
    weights.resize(mu);
    for (Eigen::Index i = 0; i < mu; ++i)
      weights(i) = std::log((static_cast<double>(population) + 1.0) / 2.0) - std::log(static_cast<double>(i) + 1.0);
    weights /= weights.sum();
    mu_eff = 1.0 / weights.squaredNorm();
    c_sigma = (mu_eff + 2.0) / (n + mu_eff + 5.0);
    d_sigma = 1.0 + 2.0 * std::max(0.0, std::sqrt((mu_eff - 1.0) / (n + 1.0)) - 1.0) + c_sigma;
    c_c = (4.0 + mu_eff / n) / (n + 4.0 + 2.0 * mu_eff / n);
    c_1 = 2.0 / ((n + 1.3) * (n + 1.3) + mu_eff);
    c_mu = std::min(1.0 - c_1, 2.0 * (mu_eff - 2.0 + 1.0 / mu_eff) / ((n + 2.0) * (n + 2.0) + mu_eff));
    chi_n = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
  }
};

}  // namespace lacuna
