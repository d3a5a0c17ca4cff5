#pragma once

#include "experiment_design/next_test.h"
#include "experiment_design/candidate_refit.h"
#include "evaluation/prediction/test_predictor.h"
#include "fitting/shooting/parameter_space.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// Predicts tests with a candidate and its derivatives by all that a refit can change. Const and shared by threads,
/// each with a worker of its own.
class CandidatePredictor {
 public:
  /// `deviations`: of the readings of `channels`, indices into the model's. `candidate` must outlive it.
  CandidatePredictor(const TestCandidate& candidate, std::vector<double> times, std::vector<Eigen::Index> channels,
                     std::vector<double> deviations, std::vector<double> start_deviation, const Work& work);

  /// False where the model cannot carry the test out.
  bool predict(const Test& test, int worker, CandidatePrediction& prediction) const;
  /// The readings after all refitted quantities have moved by these deviations, one for each column of `follows`;
  /// values stop at their bounds.
  bool predict_moved(const Test& test, int worker, const Eigen::VectorXd& deviations, Eigen::VectorXd& readings) const;

 private:
  /// A direction of the coordinates, one standard deviation long, and the step of the difference along it.
  struct Move {
    Eigen::VectorXd direction;
    double step = 0.0;  ///< deviations
  };
  /// The covariance, completed: a value that the data do not determine gets the variance of its range.
  Eigen::MatrixXd completed(Eigen::MatrixXd covariance) const;
  /// The largest step along a direction, up to a half, within the bounds of all coordinates.
  double way(const Eigen::VectorXd& direction) const;
  void add_moves(const Eigen::MatrixXd& covariance);
  bool readings_at(const Eigen::VectorXd& coordinates, const Test& test, int worker, Eigen::VectorXd& readings) const;
  /// The test with one component of the start changed by these deviations.
  Test moved_start(Test test, std::size_t component, double deviations) const;
  bool readings(std::span<const double> values, const Test& test, int worker, Eigen::VectorXd& readings) const;

  TestPredictor predictor_;
  std::vector<Eigen::Index> channels_;
  std::vector<double> deviations_;
  std::vector<double> start_deviation_;
  ParameterSpace space_;
  double command_interval_;             ///< s; 0: the timing of commands is known
  Eigen::VectorXd at_, lower_, upper_;  ///< coordinates: the values', then the timestamp offset
  std::vector<Move> moves_;
  std::vector<std::size_t> unknown_starts_;  ///< components
  std::size_t coordinates_ = 0;
};

}  // namespace lacuna
