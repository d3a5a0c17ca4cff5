#pragma once

#include "diagnosis/noise/force_responses.h"
#include "diagnosis/noise/linear_segments.h"
#include "fitting/seeded_noise.h"

#include <algorithm>
#include <vector>

namespace lacuna::test {

inline constexpr int kSegments = 40;
inline constexpr int kRows = 30;
inline constexpr double kInterval = 0.0125;  // s

/// One channel, a reading every 12.5 ms.
inline RowBins one_channel() {
  std::vector<std::vector<RowBins::Bin>> segments(kSegments);
  for (auto& bins : segments)
    for (int row = 0; row < kRows; ++row) bins.push_back({0, row * kInterval, 1.0});
  return RowBins(std::move(segments));
}

inline Eigen::MatrixXd normal(Eigen::Index rows, Eigen::Index columns, SeededNoise& random) {
  Eigen::MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped()) value = random.normal();
  return matrix;
}

/// A mass on a rail, pushed during each of ten intervals: displacement afterwards grows with time.
inline ForceResponses pushed_mass() {
  ForceResponses forces;
  forces.joints = {"rail"};
  forces.units = {"N"};
  forces.width = kRows * kInterval / 10.0;
  Eigen::MatrixXd response = Eigen::MatrixXd::Zero(kRows, 10);
  for (int pulse = 0; pulse < 10; ++pulse)
    for (int row = 0; row < kRows; ++row)
      response(row, pulse) = 50.0 * std::max(0.0, row * kInterval - (pulse + 0.5) * forces.width);
  for (int k = 0; k < kSegments; ++k) {
    forces.of.push_back({response});
    forces.times.emplace_back(Eigen::VectorXd::LinSpaced(10, 0.5 * forces.width, 9.5 * forces.width));
  }
  return forces;
}

/// A start that may be off in place and speed.
inline Eigen::MatrixXd free_start() {
  Eigen::MatrixXd state(kRows, 2);
  for (int row = 0; row < kRows; ++row) state.row(row) << 100.0, 100.0 * row * kInterval;
  return state;
}

}  // namespace lacuna::test
