#pragma once

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// Autocorrelation of a residual, with the band for white noise.
struct Autocorrelation {
  std::vector<double> lags;    ///< s
  std::vector<double> values;  ///< correlation at each lag
  double band = 0.0;           ///< 99 % of the values of white noise lie within ± this
  double share_outside = 0.0;  ///< share of lags outside the band; 0.01 for white noise
  double statistic = 0.0;      ///< Ljung and Box's (1978), χ² of `freedom`
  int freedom = 0;
  double p = 1.0;
};

/// Autocorrelation of the residuals of one channel, one vector per trial, equally spaced by `interval` s; NaN where
/// nothing was measured. Trials are pooled and their common mean removed. Lags go as far as the residual's memory, at
/// most a quarter of the longest trial. A residual without any power gives no lags and p = 1.
Autocorrelation autocorrelation(const std::vector<Eigen::VectorXd>& residuals, double interval);

/// Samples with similar values of a feature, and the mean residual among them.
struct ResidualBin {
  double lower = 0.0, upper = 0.0;  ///< feature
  double feature = 0.0;             ///< its mean
  double mean = 0.0;                ///< of the residual
  double band = 0.0;  ///< the 99 % interval of the mean is mean ± band, including the uncertainty of the slope
  std::size_t samples = 0;
};

/// Whether the mean of a residual depends on a feature.
struct IndependenceTest {
  bool testable = false;   ///< false: the feature does not vary, or there are too few samples
  double share = 0.0;      ///< of the squared residual: the part that varies with the feature, 0 to 1
  double statistic = 0.0;  ///< F of `numerator` and `denominator` degrees of freedom
  double critical = 0.0;   ///< the 99 % band of the statistic, corrected for the family of tests
  int numerator = 0;
  int denominator = 0;
  double p = 1.0;  ///< of this test alone
  /// The values whose means the bins show, one per row (NaN: not used): the residual, or, with covariates, the rest
  /// that neither they nor the feature explain plus the feature's part (a component-plus-residual plot).
  Eigen::VectorXd shown;
  std::vector<ResidualBin> bins;
};

/// Tests of one residual, in the order of time. The residual may be autocorrelated: the covariance of the scores is the
/// long-run one, estimated from ν cosine-weighted sums of them (Sun, "A heteroskedasticity and autocorrelation robust F
/// test using an orthonormal series variance estimator", Econometrics Journal 16, 2013), which leaves an F statistic
/// with few degrees of freedom where the memory is long. The memory counted is that of the residual after the feature's
/// part is removed, so that an error as periodic as the motion is still detected.
class ResidualTester {
 public:
  /// Rows where `residual` or a covariate is NaN are not used. `covariates` (rows × any number) explain what they can
  /// first: dependence is what a feature adds to them. `family`: number of tests that share the 1 % of false alarms
  /// (Bonferroni).
  ResidualTester(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariates, std::size_t family);

  /// Linear and quadratic in the feature.
  IndependenceTest of(const Eigen::VectorXd& feature) const;
  /// Linear in a feature with a few values such as −1, 0 and 1.
  IndependenceTest of_classes(const Eigen::VectorXd& feature) const;
  /// Of a zero mean; `share` is that of the squared mean. Without covariates.
  IndependenceTest of_mean() const;

 private:
  IndependenceTest test(const Eigen::VectorXd& feature, bool classes) const;
  /// Returns the long-run covariance of the sums.
  Eigen::MatrixXd judge(const Eigen::MatrixXd& scores, const Eigen::VectorXd& kept, const Eigen::VectorXd& sums,
                        double memory, IndependenceTest& result) const;
  /// Variance of the weighted scores, one value per column of the basis: the part that the regression leaves.
  Eigen::VectorXd share_kept(const Eigen::MatrixXd& basis, int weights) const;
  Eigen::MatrixXd without_covariates(const Eigen::MatrixXd& columns) const;
  /// `parts` (rows × any number): the part of `shown` that depends on the feature, per standard deviation of each
  /// independent coefficient.
  std::vector<ResidualBin> bins(const Eigen::VectorXd& feature, const Eigen::VectorXd& shown,
                                const Eigen::MatrixXd& parts, std::size_t most) const;

  Eigen::Index all_rows_ = 0;
  std::vector<Eigen::Index> rows_;  ///< that count
  double squares_ = 0.0;            ///< of the residual
  Eigen::VectorXd raw_;             ///< of these rows
  Eigen::MatrixXd taken_;           ///< orthonormal: a constant and the covariates
  Eigen::VectorXd residual_;        ///< without their component in that basis
  std::size_t family_;
  Eigen::MatrixXd cosines_;  ///< rows × most weights
};

/// The columns that test a feature: itself and its square, or itself alone, of mean 0 and comparable size. None for a
/// feature that does not vary.
Eigen::MatrixXd feature_basis(const Eigen::VectorXd& feature, bool classes);

}  // namespace lacuna
