#pragma once

#include "experiment_design/next_test.h"
#include "experiment_design/rival_refit.h"
#include "evaluation/prediction/test_predictor.h"
#include "fitting/shooting/parameter_space.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// Predicts tests with a model and with all that a refit could change. Const and shared by threads, each with a worker
/// of its own.
class RivalPredictor {
 public:
  /// `deviations`: of the readings of `channels`, indices into the model's. `rival` must outlive it.
  RivalPredictor(const RivalModel& rival, std::vector<double> times, std::vector<Eigen::Index> channels,
                 std::vector<double> deviations, std::vector<double> start_deviation, int workers);

  /// False where the model cannot carry the test out.
  bool predict(const Test& test, int worker, RivalPrediction& prediction) const;
  /// The readings when everything that is refitted has moved by so many deviations, one a column of `follows`; values
  /// stop at their bounds.
  bool predict_moved(const Test& test, int worker, const Eigen::VectorXd& deviations, Eigen::VectorXd& readings) const;

 private:
  /// A direction of the coordinates, one standard deviation long, and how far a difference goes along it.
  struct Move {
    Eigen::VectorXd direction;
    double step = 0.0;  ///< deviations
  };
  /// The covariance with what it does not say: what the data leave open has that of its range.
  Eigen::MatrixXd completed(Eigen::MatrixXd covariance) const;
  /// How far one can go along a direction, up to a half, before a coordinate leaves its bounds.
  double way(const Eigen::VectorXd& direction) const;
  void add_moves(const Eigen::MatrixXd& covariance);
  bool readings_at(const Eigen::VectorXd& coordinates, const Test& test, int worker, Eigen::VectorXd& readings) const;
  /// The test, begun so many deviations off in a component of the start.
  Test moved_start(Test test, std::size_t component, double deviations) const;
  bool readings(std::span<const double> values, const Test& test, int worker, Eigen::VectorXd& readings) const;

  TestPredictor predictor_;
  std::vector<Eigen::Index> channels_;
  std::vector<double> deviations_;
  std::vector<double> start_deviation_;
  ParameterSpace space_;
  double command_interval_;             ///< s; 0: commands act when they are said to
  Eigen::VectorXd at_, lower_, upper_;  ///< coordinates: the values', then where the commands act
  std::vector<Move> moves_;
  std::vector<std::size_t> unknown_starts_;  ///< components
  std::size_t coordinates_ = 0;
};

}  // namespace lacuna
