#include "diagnosis/rival_predictor.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr double kMove = 0.5;           ///< standard deviations, of a difference
constexpr double kStartMove = 0.005;    ///< the same of the start, whose deviations are wide (test_conditions.h)
constexpr double kSmallestMove = 1e-3;  ///< what the bounds leave less than this of is held
constexpr double kAtBound = 1e-9;       ///< of a range

/// The covariance with what it does not say: values that the data leave open have that of their range.
Eigen::MatrixXd completed(const RivalModel& rival, const ParameterSpace& space, const Eigen::VectorXd& at) {
  Eigen::MatrixXd covariance = rival.covariance;
  for (Eigen::Index j = 0; j < space.size(); ++j) {
    const double variance = covariance(j, j);
    if (std::isfinite(variance) && variance > 0.0) continue;
    covariance.row(j).setZero();
    covariance.col(j).setZero();
    const double range = space.upper()(j) - space.lower()(j);
    const bool at_bound = at(j) <= space.lower()(j) + kAtBound * range || at(j) >= space.upper()(j) - kAtBound * range;
    if (!at_bound && std::isfinite(range)) covariance(j, j) = range * range / 12.0;
  }
  return covariance;
}

/// How far one can go along a direction, up to `kMove`, before a value leaves its bounds.
double way(const ParameterSpace& space, const Eigen::VectorXd& at, const Eigen::VectorXd& direction) {
  double most = kMove;
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    if (direction(j) > 0.0) most = std::min(most, (space.upper()(j) - at(j)) / direction(j));
    if (direction(j) < 0.0) most = std::min(most, (space.lower()(j) - at(j)) / direction(j));
  }
  return most;
}

}  // namespace

RivalPredictor::RivalPredictor(const RivalModel& rival, std::vector<double> times, std::vector<Eigen::Index> channels,
                               std::vector<double> deviations, std::vector<double> start_deviation, int workers)
    : predictor_(rival.model, std::move(times), workers),
      channels_(std::move(channels)),
      deviations_(std::move(deviations)),
      start_deviation_(std::move(start_deviation)),
      space_(rival.definition.free),
      at_(space_.to_coordinates(rival.values)),
      values_(rival.values),
      coordinates_(rival.model.coordinates().size()) {
  add_moves(rival);
  for (std::size_t i = 0; i < start_deviation_.size(); ++i)
    if (start_deviation_[i] > 0.0) unknown_starts_.push_back(i);
}

void RivalPredictor::add_moves(const RivalModel& rival) {
  if (space_.size() == 0) return;
  const Eigen::MatrixXd covariance = completed(rival, space_, at_);
  const Eigen::VectorXd sizes = covariance.diagonal().cwiseSqrt();
  const Eigen::VectorXd inverse = sizes.unaryExpr([](double size) { return size > 0.0 ? 1.0 / size : 0.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(inverse.asDiagonal() * covariance * inverse.asDiagonal());
  for (Eigen::Index k = 0; k < space_.size(); ++k) {
    if (!(eigen.eigenvalues()(k) > 0.0)) continue;
    const Eigen::VectorXd direction =
        std::sqrt(eigen.eigenvalues()(k)) * sizes.cwiseProduct(eigen.eigenvectors().col(k));
    const double forth = way(space_, at_, direction), back = way(space_, at_, -direction);
    const double step = forth >= back ? forth : -back;
    if (std::abs(step) >= kSmallestMove) moves_.push_back({direction, step});
  }
}

std::vector<double> RivalPredictor::values_at(const Eigen::VectorXd& coordinates) const {
  return space_.to_values(space_.clamp(coordinates));
}

Test RivalPredictor::moved_start(Test test, std::size_t component, double deviations) const {
  test.start.positions.resize(coordinates_, 0.0);
  test.start.velocities.resize(coordinates_, 0.0);
  auto& part = component < coordinates_ ? test.start.positions : test.start.velocities;
  part[component % coordinates_] += deviations * start_deviation_[component];
  return test;
}

bool RivalPredictor::readings(std::span<const double> values, const Test& test, int worker,
                              Eigen::VectorXd& readings) const {
  TestPrediction prediction;
  std::uint64_t steps = 0;
  std::string reason;
  if (!predictor_.predict({{values.begin(), values.end()}}, test, worker, prediction, steps, reason)) return false;
  const TimeSeries::Samples& samples = prediction.sensors.samples;
  readings.resize(samples.rows() * static_cast<Eigen::Index>(channels_.size()));
  for (std::size_t c = 0; c < channels_.size(); ++c)
    readings.segment(static_cast<Eigen::Index>(c) * samples.rows(), samples.rows()) =
        samples.col(channels_[c]) / deviations_[c];
  return readings.allFinite();
}

bool RivalPredictor::predict(const Test& test, int worker, RivalPrediction& prediction) const {
  if (!readings(values_, test, worker, prediction.readings)) return false;
  prediction.follows.resize(prediction.readings.size(),
                            static_cast<Eigen::Index>(moves_.size() + unknown_starts_.size()));
  Eigen::VectorXd moved;
  Eigen::Index column = 0;
  for (const Move& move : moves_) {
    if (!readings(values_at(at_ + move.step * move.direction), test, worker, moved)) return false;
    prediction.follows.col(column++) = (moved - prediction.readings) / move.step;
  }
  for (const std::size_t component : unknown_starts_) {
    if (!readings(values_, moved_start(test, component, kStartMove), worker, moved)) return false;
    prediction.follows.col(column++) = (moved - prediction.readings) / kStartMove;
  }
  return true;
}

bool RivalPredictor::predict_moved(const Test& test, int worker, const Eigen::VectorXd& deviations,
                                   Eigen::VectorXd& moved) const {
  Eigen::VectorXd at = at_;
  Test from = test;
  Eigen::Index column = 0;
  for (const Move& move : moves_) at += deviations(column++) * move.direction;
  for (const std::size_t component : unknown_starts_) from = moved_start(from, component, deviations(column++));
  return readings(values_at(at), from, worker, moved);
}

}  // namespace lacuna
