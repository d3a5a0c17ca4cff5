#include "pair_difference.h"

#include <lacuna/error.h>

#include <Eigen/Cholesky>

#include <string>

namespace lacuna {

PairDifference::PairDifference(const TestPrediction& one, const TestPrediction& other, std::span<const double> noise)
    : one_(one),
      other_(other),
      inverse_noise_(
          Eigen::Map<const Eigen::VectorXd>(noise.data(), static_cast<Eigen::Index>(noise.size())).cwiseInverse()) {
  const TimeSeries::Samples &a = one.sensors.samples, &b = other.sensors.samples;
  if (a.rows() != b.rows() || a.cols() != b.cols())
    throw Error("the models predict " + std::to_string(a.rows()) + " × " + std::to_string(a.cols()) + " and " +
                std::to_string(b.rows()) + " × " + std::to_string(b.cols()) +
                " readings; they must be of one test and the same sensors");
  if (inverse_noise_.size() != a.cols())
    throw Error("the noise of " + std::to_string(noise.size()) + " sensor channels is known, but the models predict " +
                std::to_string(a.cols()));
  difference_ = in_deviations(a - b);
}

Eigen::VectorXd PairDifference::in_deviations(const TimeSeries::Samples& readings) const {
  TimeSeries::Samples scaled = readings * inverse_noise_.asDiagonal();
  return Eigen::Map<const Eigen::VectorXd>(scaled.data(), scaled.size());
}

double PairDifference::left_by(const TestPrediction& wrong) const {
  const Eigen::MatrixXd& known = wrong.information;
  const auto values = static_cast<Eigen::Index>(wrong.slopes.size());
  if (known.rows() != values || known.cols() != values)
    throw Error("the information on " + std::to_string(values) + " values is a matrix of " +
                std::to_string(known.rows()) + " × " + std::to_string(known.cols()));
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(difference_.size(), values);
  for (Eigen::Index k = 0; k < values; ++k) {
    const TimeSeries::Samples& slope = wrong.slopes[static_cast<std::size_t>(k)];
    if (slope.size() > 0) slopes.col(k) = in_deviations(slope);
  }
  // The sign of the difference, and so which model is wrong, does not matter: min |d − S v|² + vᵀ K v.
  const Eigen::VectorXd pull = slopes.transpose() * difference_;
  const Eigen::MatrixXd stiffness = slopes.transpose() * slopes + known;
  return difference_.squaredNorm() - pull.dot(stiffness.ldlt().solve(pull));
}

}  // namespace lacuna
