#include "experiment_design/candidate_predictor.h"

#include "candidates/timing.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace lacuna {
namespace {

constexpr double kMove = 0.5;           ///< standard deviations, of a difference
constexpr double kStartMove = 0.005;    ///< the same for the start, whose deviations are wide (test_conditions.h)
constexpr double kSmallestMove = 1e-3;  ///< a value whose bounds leave less than this is held
constexpr double kAtBound = 1e-9;       ///< of a range

/// The test with its commands so much later, s.
Test later(Test test, double delay) {
  if (auto* commands = std::get_if<CommandSeries>(&test.drive)) commands->series.times.array() += delay;
  return test;
}

}  // namespace

CandidatePredictor::CandidatePredictor(const TestCandidate& candidate, std::vector<double> times,
                                       std::vector<Eigen::Index> channels, std::vector<double> deviations,
                                       std::vector<double> start_deviation, const Work& work)
    : predictor_(candidate.model, std::move(times), work),
      channels_(std::move(channels)),
      deviations_(std::move(deviations)),
      start_deviation_(std::move(start_deviation)),
      space_(candidate.definition.free),
      command_interval_(candidate.command_interval),
      at_(Eigen::VectorXd::Zero(candidate.coordinates())),
      lower_(Eigen::VectorXd::Constant(candidate.coordinates(), -kMostTiming)),
      upper_(Eigen::VectorXd::Constant(candidate.coordinates(), kMostTiming)),
      coordinates_(candidate.model.coordinates().size()) {
  at_.head(space_.size()) = space_.to_coordinates(candidate.values);
  lower_.head(space_.size()) = space_.lower();
  upper_.head(space_.size()) = space_.upper();
  if (command_interval_ > 0.0) at_(space_.size()) = candidate.command_shift;
  add_moves(completed(candidate.covariance));
  for (std::size_t i = 0; i < start_deviation_.size(); ++i)
    if (start_deviation_[i] > 0.0) unknown_starts_.push_back(i);
}

Eigen::MatrixXd CandidatePredictor::completed(Eigen::MatrixXd covariance) const {
  for (Eigen::Index j = 0; j < at_.size(); ++j) {
    const double variance = covariance(j, j);
    if (std::isfinite(variance) && variance > 0.0) continue;
    covariance.row(j).setZero();
    covariance.col(j).setZero();
    const double range = upper_(j) - lower_(j);
    const bool at_bound = at_(j) <= lower_(j) + kAtBound * range || at_(j) >= upper_(j) - kAtBound * range;
    if (!at_bound && std::isfinite(range)) covariance(j, j) = range * range / 12.0;
  }
  return covariance;
}

double CandidatePredictor::way(const Eigen::VectorXd& direction) const {
  double most = kMove;
  for (Eigen::Index j = 0; j < at_.size(); ++j) {
    if (direction(j) > 0.0) most = std::min(most, (upper_(j) - at_(j)) / direction(j));
    if (direction(j) < 0.0) most = std::min(most, (lower_(j) - at_(j)) / direction(j));
  }
  return most;
}

void CandidatePredictor::add_moves(const Eigen::MatrixXd& covariance) {
  if (at_.size() == 0) return;
  const Eigen::VectorXd sizes = covariance.diagonal().cwiseSqrt();
  const Eigen::VectorXd inverse = sizes.unaryExpr([](double size) { return size > 0.0 ? 1.0 / size : 0.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(inverse.asDiagonal() * covariance * inverse.asDiagonal());
  for (Eigen::Index k = 0; k < at_.size(); ++k) {
    if (!(eigen.eigenvalues()(k) > 0.0)) continue;
    const Eigen::VectorXd direction =
        std::sqrt(eigen.eigenvalues()(k)) * sizes.cwiseProduct(eigen.eigenvectors().col(k));
    const double forth = way(direction), back = way(-direction);
    const double step = forth >= back ? forth : -back;
    if (std::abs(step) >= kSmallestMove) moves_.push_back({direction, step});
  }
}

Test CandidatePredictor::moved_start(Test test, std::size_t component, double deviations) const {
  test.start.positions.resize(coordinates_, 0.0);
  test.start.velocities.resize(coordinates_, 0.0);
  auto& part = component < coordinates_ ? test.start.positions : test.start.velocities;
  part[component % coordinates_] += deviations * start_deviation_[component];
  return test;
}

bool CandidatePredictor::readings(std::span<const double> values, const Test& test, int worker,
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

bool CandidatePredictor::readings_at(const Eigen::VectorXd& coordinates, const Test& test, int worker,
                                     Eigen::VectorXd& moved) const {
  const Eigen::VectorXd within = coordinates.cwiseMax(lower_).cwiseMin(upper_);
  const std::vector<double> values = space_.to_values(within.head(space_.size()));
  if (command_interval_ == 0.0) return readings(values, test, worker, moved);
  return readings(values, later(test, within(space_.size()) * command_interval_), worker, moved);
}

bool CandidatePredictor::predict(const Test& test, int worker, CandidatePrediction& prediction) const {
  if (!readings_at(at_, test, worker, prediction.readings)) return false;
  prediction.follows.resize(prediction.readings.size(),
                            static_cast<Eigen::Index>(moves_.size() + unknown_starts_.size()));
  Eigen::VectorXd moved;
  Eigen::Index column = 0;
  for (const Move& move : moves_) {
    if (!readings_at(at_ + move.step * move.direction, test, worker, moved)) return false;
    prediction.follows.col(column++) = (moved - prediction.readings) / move.step;
  }
  for (const std::size_t component : unknown_starts_) {
    if (!readings_at(at_, moved_start(test, component, kStartMove), worker, moved)) return false;
    prediction.follows.col(column++) = (moved - prediction.readings) / kStartMove;
  }
  return true;
}

bool CandidatePredictor::predict_moved(const Test& test, int worker, const Eigen::VectorXd& deviations,
                                       Eigen::VectorXd& moved) const {
  Eigen::VectorXd at = at_;
  Test from = test;
  Eigen::Index column = 0;
  for (const Move& move : moves_) at += deviations(column++) * move.direction;
  for (const std::size_t component : unknown_starts_) from = moved_start(from, component, deviations(column++));
  return readings_at(at, from, worker, moved);
}

}  // namespace lacuna
