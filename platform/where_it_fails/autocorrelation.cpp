#include "where_it_fails/residual_tests.h"

#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kNormal99 = 2.5758;  // 99 % of a normal variable lie within ± this
constexpr Eigen::Index kFewestLags = 40, kMostPoints = 120;
constexpr int kTestedLags = 20;

/// Sums over trials of products at a lag; rows without a value count as zero.
class Products {
 public:
  explicit Products(const std::vector<Eigen::VectorXd>& residuals) : centred_(residuals) {
    double sum = 0.0;
    for (const Eigen::VectorXd& trial : residuals)
      for (const double value : trial)
        if (std::isfinite(value)) {
          sum += value;
          count_ += 1.0;
        }
    for (Eigen::VectorXd& trial : centred_) {
      longest_ = std::max(longest_, trial.size());
      for (double& value : trial) value = std::isfinite(value) ? value - sum / count_ : 0.0;
    }
    power_ = at(0);
  }

  double at(Eigen::Index lag) const {
    double sum = 0.0;
    for (const Eigen::VectorXd& trial : centred_)
      if (trial.size() > lag) sum += trial.head(trial.size() - lag).dot(trial.tail(trial.size() - lag));
    return sum;
  }
  double correlation(Eigen::Index lag) const { return at(lag) / power_; }
  double count() const { return count_; }
  double power() const { return power_; }
  Eigen::Index longest() const { return longest_; }

  /// The lag at which the correlation has first fallen into the band, found in growing steps.
  Eigen::Index memory(double band) const {
    Eigen::Index lag = 1;
    while (lag < longest_ / 4 && correlation(lag) > band) lag += std::max<Eigen::Index>(1, lag / 4);
    return lag;
  }

 private:
  std::vector<Eigen::VectorXd> centred_;
  double count_ = 0.0, power_ = 0.0;
  Eigen::Index longest_ = 0;
};

}  // namespace

Autocorrelation autocorrelation(const std::vector<Eigen::VectorXd>& residuals, double interval) {
  Autocorrelation result;
  const Products products(residuals);
  const Eigen::Index most = products.longest() / 4;
  if (!(products.power() > 0.0) || most < 1) return result;
  result.band = kNormal99 / std::sqrt(products.count());
  const Eigen::Index last = std::clamp(4 * products.memory(result.band), std::min(kFewestLags, most), most);
  const Eigen::Index step = (last + kMostPoints - 1) / kMostPoints;
  double outside = 0.0;
  for (Eigen::Index lag = step; lag <= last; lag += step) {
    result.lags.push_back(static_cast<double>(lag) * interval);
    result.values.push_back(products.correlation(lag));
    outside += std::abs(result.values.back()) > result.band ? 1.0 : 0.0;
  }
  result.share_outside = outside / static_cast<double>(result.lags.size());
  result.freedom = static_cast<int>(std::min<Eigen::Index>(kTestedLags, most));
  const double n = products.count();
  for (int lag = 1; lag <= result.freedom; ++lag)
    result.statistic += n * (n + 2.0) * std::pow(products.correlation(lag), 2) / (n - lag);
  result.p = boost::math::cdf(
      boost::math::complement(boost::math::chi_squared(result.freedom), std::max(0.0, result.statistic)));
  return result;
}

}  // namespace lacuna
