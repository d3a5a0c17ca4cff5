#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace hidden_effects {

/// A figure with its 95 % interval and what it rests on. NaN where there is nothing to say.
struct Estimate {
  std::size_t n = 0;
  double value = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
};

/// A stated probability, and whether what it was stated of is so (1) or not (0).
struct Stated {
  double probability = 0.0;
  double is_right = 0.0;
};

/// The mean of values from 0 to 1 with E. B. Wilson's interval (J. Am. Stat. Assoc. 22 (1927) 209-212). Values between
/// the two scatter less than those at the ends, so that it is wide enough for them, too.
Estimate share(const std::vector<double>& values);

double mean(const std::vector<double>& values);
double median(std::vector<double> values);

/// Mean of |stated probability − share that is right| over `bins` equally wide bins, weighted by how many each holds.
double calibration_error(const std::vector<Stated>& stated, int bins = 10);

/// What `calibration_error` would be, were each stated probability exact: its mean over 2000 draws of who is right,
/// always the same ones, and where 95 % of them lie. With few verdicts it is far from 0.
Estimate calibration_error_by_chance(const std::vector<Stated>& stated);

/// Mean of (stated probability − is_right)² (G. W. Brier, Monthly Weather Review 78 (1950) 1-3).
double brier_score(const std::vector<Stated>& stated);

/// A statistic with the percentile interval of 2000 resamples, always the same ones (B. Efron, Ann. Stat. 7 (1979)
/// 1-26). Below two items there is no interval.
Estimate bootstrap(const std::vector<double>& values, const std::function<double(const std::vector<double>&)>& of);
Estimate bootstrap(const std::vector<Stated>& stated, const std::function<double(const std::vector<Stated>&)>& of);

}  // namespace hidden_effects
