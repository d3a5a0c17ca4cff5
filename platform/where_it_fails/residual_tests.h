#pragma once

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// How a residual depends on its own past, with what white noise would show.
struct Autocorrelation {
  std::vector<double> lags;    ///< s
  std::vector<double> values;  ///< correlation at each lag
  double band = 0.0;           ///< 99 % of the values of white noise lie within ± this
  double share_outside = 0.0;  ///< of the lags; 0.01 for white noise
  double statistic = 0.0;      ///< Ljung and Box's (1978), χ² of `freedom`
  int freedom = 0;
  double p = 1.0;
};

/// Of the residuals of one channel, a vector a trial, equally spaced by `interval` s; NaN where nothing was measured.
/// Trials are pooled, their common mean taken off. Lags go as far as the residual remembers, at most over a quarter of
/// the longest trial. A residual without any power gives no lags and p = 1.
Autocorrelation autocorrelation(const std::vector<Eigen::VectorXd>& residuals, double interval);

/// Samples of like value of a feature, and the mean residual among them.
struct ResidualBin {
  double lower = 0.0, upper = 0.0;  ///< feature
  double feature = 0.0;             ///< its mean
  double mean = 0.0;                ///< of the residual
  double band = 0.0;                ///< 99 % interval of that mean is mean ± band, the uncertain slope allowed for
  std::size_t samples = 0;
};

/// Whether the mean of a residual depends on a feature.
struct IndependenceTest {
  bool testable = false;   ///< false: the feature does not vary, or there are too few samples
  double share = 0.0;      ///< of the squared residual that varies with the feature, 0 to 1
  double statistic = 0.0;  ///< F of `numerator` and `denominator` degrees of freedom
  double critical = 0.0;   ///< the 99 % band of the statistic, all tests of a family allowed for
  int numerator = 0;
  int denominator = 0;
  double p = 1.0;  ///< of this test alone
  /// What the bins are means of, a value a row given (NaN: it did not count): the residual, or, beside covariates, what
  /// neither they nor the feature explain plus the feature's own part (a component-plus-residual plot).
  Eigen::VectorXd shown;
  std::vector<ResidualBin> bins;
};

/// Tests of one residual, in the order of time. The residual may remember its past: the covariance of the scores is the
/// long-run one, estimated from ν cosine-weighted sums of them (Sun, "A heteroskedasticity and autocorrelation robust F
/// test using an orthonormal series variance estimator", Econometrics Journal 16, 2013), which leaves an F statistic
/// with few degrees of freedom where the residual remembers long. It is the residual that is left after the feature
/// took its part whose memory counts, so that an error that repeats as regularly as the motion does is seen all the
/// same.
class ResidualTester {
 public:
  /// Rows where `residual` or a covariate is NaN do not count. `covariates` (rows × any number) may explain what they
  /// can first: dependence is what a feature adds to them. `family`: how many tests share the 1 % of false alarms
  /// (Bonferroni).
  ResidualTester(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariates, std::size_t family);

  /// Linear and quadratic in the feature.
  IndependenceTest of(const Eigen::VectorXd& feature) const;
  /// Linear in the feature, which takes a few values such as −1, 0 and 1.
  IndependenceTest of_classes(const Eigen::VectorXd& feature) const;
  /// Of a mean of zero; `share` is that of the squared mean. Covariates explain nothing of it.
  IndependenceTest of_mean() const;

 private:
  IndependenceTest test(const Eigen::VectorXd& feature, bool classes) const;
  /// Returns the long-run covariance of the sums.
  Eigen::MatrixXd judge(const Eigen::MatrixXd& scores, const Eigen::VectorXd& kept, const Eigen::VectorXd& sums,
                        double memory, IndependenceTest& result) const;
  /// Of the variance of the weighted scores, a value a column of the basis: what the regression leaves.
  Eigen::VectorXd share_kept(const Eigen::MatrixXd& basis, int weights) const;
  Eigen::MatrixXd without_covariates(const Eigen::MatrixXd& columns) const;
  /// `parts` (rows × any number): what of `shown` depends on the feature, by deviation of an independent coefficient.
  std::vector<ResidualBin> bins(const Eigen::VectorXd& feature, const Eigen::VectorXd& shown,
                                const Eigen::MatrixXd& parts, std::size_t most) const;

  Eigen::Index all_rows_ = 0;
  std::vector<Eigen::Index> rows_;  ///< that count
  double squares_ = 0.0;            ///< of the residual
  Eigen::VectorXd raw_;             ///< of these rows
  Eigen::MatrixXd taken_;           ///< orthonormal: a constant and the covariates
  Eigen::VectorXd residual_;        ///< without what these explain
  std::size_t family_;
  Eigen::MatrixXd cosines_;  ///< rows × most weights
};

/// The columns that a feature is tested by: itself and its square, or itself alone, of mean 0 and comparable size. A
/// feature that does not vary has none.
Eigen::MatrixXd feature_basis(const Eigen::VectorXd& feature, bool classes);

}  // namespace lacuna
