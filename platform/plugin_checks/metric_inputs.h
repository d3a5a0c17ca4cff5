#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace lacuna {

/// A comparison on which metrics are tried, here and in the conformance tests.

inline constexpr std::size_t kComparedSamples = 300, kComparedChannels = 3;
inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kScoreRounding = 1e-12;  ///< share of a score by which a bound may exceed it

struct ComparedSample {
  std::vector<double> predicted, measured;  ///< a value a channel
};

/// Sine waves that agree better and better, with gaps in what is measured.
inline std::vector<ComparedSample> compared_sines() {
  std::vector<ComparedSample> all;
  for (std::size_t i = 0; i < kComparedSamples; ++i) {
    ComparedSample sample;
    for (std::size_t c = 0; c < kComparedChannels; ++c) {
      const double t = 0.05 * static_cast<double>(i) + static_cast<double>(c);
      sample.predicted.push_back(std::sin(t));
      sample.measured.push_back((i + c) % 7 == 0 ? kNotMeasured : std::sin(1.02 * t) + 0.3 / (1.0 + t));
    }
    all.push_back(sample);
  }
  return all;
}

/// The same where each prediction that has nothing to be compared with is far off.
inline std::vector<ComparedSample> sines_off_where_not_measured() {
  std::vector<ComparedSample> all = compared_sines();
  for (ComparedSample& sample : all)
    for (std::size_t c = 0; c < kComparedChannels; ++c)
      if (std::isnan(sample.measured[c])) sample.predicted[c] = 1e6;
  return all;
}

/// The same with each prediction off by 5 more.
inline std::vector<ComparedSample> worse_sines() {
  std::vector<ComparedSample> all = compared_sines();
  for (ComparedSample& sample : all)
    for (double& value : sample.predicted) value += 5.0;
  return all;
}

/// The same with a prediction in its middle that is `bad`, such as no number.
inline std::vector<ComparedSample> broken_sines(double bad) {
  std::vector<ComparedSample> all = compared_sines();
  all[kComparedSamples / 2].predicted.assign(kComparedChannels, bad);
  return all;
}

}  // namespace lacuna
