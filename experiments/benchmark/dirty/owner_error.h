#pragma once

#include "dirty/true_trial.h"

#include <Eigen/Core>

#include <vector>

namespace hidden_effects::dirty {

/// A model of the owner: the robot file's values, and laws that it has beyond it, each with its number among the
/// truth's, from which it takes what it remembers.
struct OwnerModel {
  PlantSpec spec;
  Laws laws;
  std::vector<std::size_t> of_truth;
  int finer = 1;
};

/// Readings without noise, by trial and sensor.
using DenseData = std::vector<std::vector<DenseReadings>>;

/// How far an owner's model is off, its free values refitted, in units of the noise. Predictions start from the state
/// that noise-free readings show and run over segments of three lengths: the longest over which the rig's predictions
/// mean something, a sixteenth of it but ten samples at least, and one in between. The error is the root mean square
/// over the segments and sensors of a length, and the geometric mean over the lengths. The refit, damped Gauss-Newton,
/// makes that mean as small as it can.
class OwnerError {
 public:
  struct Effort {
    double most_steps = 4000.0;  ///< integration steps of one prediction of a length, on one joint
    int most_refits = 5;
    bool worst = false;  ///< the error is that of the worst length instead of the mean over them
  };

  /// Of the trials that are not held out. `noise`: standard deviation by sensor. All but the last have to outlive it.
  OwnerError(const DirtyRig& rig, const Truth& truth, const std::vector<TrueTrial>& trials,
             const std::vector<double>& noise, const Effort& effort);

  /// RMS over the noise; never below a hundredth.
  double of(const OwnerModel& model, const DenseData& data) const;

  /// The same of a model whose free values are the true ones.
  double unfitted(const OwnerModel& model, const DenseData& data) const;

 private:
  Eigen::MatrixXd slopes(const OwnerModel& model, const DenseData& data, const Eigen::VectorXd& values,
                         const Eigen::VectorXd& left) const;
  Eigen::VectorXd step(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& left) const;
  Eigen::VectorXd within_bounds(Eigen::VectorXd values) const;
  double told(const std::vector<double>& squares) const;
  struct Segment {
    std::size_t trial, begin, length;
    std::size_t block;  ///< number of its length
  };
  void choose_segments(double most_steps);
  Eigen::VectorXd residuals(const OwnerModel& model, const DenseData& data, const Eigen::VectorXd& values) const;
  Eigen::VectorXd imposed_residuals(const PlantSpec& spec, const OwnerModel& model, const DenseData& data) const;
  PlantState start(const Simulation& plant, const OwnerModel& model, const DenseData& data, const Segment& at) const;
  std::vector<double> mean_squares(const Eigen::VectorXd& residuals) const;
  Eigen::VectorXd true_values() const;
  PlantSpec at_values(PlantSpec spec, const Eigen::VectorXd& values) const;

  const DirtyRig& rig_;
  const Truth& truth_;
  const std::vector<TrueTrial>& trials_;
  const std::vector<double>& noise_;
  Effort effort_;
  std::vector<Segment> segments_;
  std::vector<std::size_t> block_of_row_;
  std::size_t blocks_ = 1;
};

/// What all sensors read, with those laws of the truth that are not `without`.
DenseData clean_readings(const Truth& truth, const std::vector<TrueTrial>& trials, const Law* without = nullptr);

}  // namespace hidden_effects::dirty
