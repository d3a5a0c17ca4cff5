#pragma once

#include "evaluation/prediction/trial_predictor.h"
#include "fitting/numerics/least_squares.h"
#include "fitting/shooting/parameter_space.h"
#include "fitting/starts/segments.h"

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// The place of a residual in the measurement.
struct ResidualPlace {
  std::size_t trial = 0;
  double time = 0.0;        ///< s
  std::size_t channel = 0;  ///< index into the noise list
};

/// Residuals of all segments of a stage: measured minus predicted, over one scale per channel, then the deviation of
/// each initial state from its prior. Simulations run in parallel over segments and, for derivatives, over segments ×
/// columns; every result has its own place, so that the digits do not depend on threads.
class ShootingProblem : public SegmentedProblem {
 public:
  ShootingProblem(const TrialPredictor& predictor, const ParameterSpace& space, std::vector<Segment> segments,
                  const std::vector<ChannelNoise>& noise);
  /// The same problem with another predictor's workers and zero counts.
  ShootingProblem(const ShootingProblem& other, const TrialPredictor& predictor);

  const TrialPredictor& predictor() const { return predictor_; }
  const Eigen::VectorXd& lower() const override { return space_.lower(); }
  const Eigen::VectorXd& upper() const override { return space_.upper(); }
  Eigen::Index robust_rows(std::size_t k) const override { return static_cast<Eigen::Index>(segments_[k].rows.size()); }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override;
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override;
  /// The same by central differences: twice the simulations, for covariance and identifiability.
  void linearize_finely(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                        std::vector<SegmentJacobian>& jacobians);
  /// Derivatives by the initial states alone, without columns of shared values.
  void linearize_states(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                        std::vector<SegmentJacobian>& jacobians);

  const std::vector<Segment>& segments() const { return segments_; }
  /// The point with every start state at its guess.
  FitPoint start(const Eigen::VectorXd& values) const;
  ResidualPlace place(std::size_t k, Eigen::Index row) const;
  std::size_t samples() const { return samples_; }

  /// What residuals are divided by, one a channel of the noise list.
  const std::vector<double>& scales() const { return scales_; }
  void set_scales(std::vector<double> scales) { scales_ = std::move(scales); }
  const std::vector<ChannelNoise>& noise() const { return noise_; }

  /// Difference steps, which follow the residual; another problem of the same model may start with them.
  const std::vector<double>& steps() const { return steps_; }
  void set_steps(std::vector<double> steps) { steps_ = std::move(steps); }

  /// Number of independent simulations for a derivative.
  std::size_t simulations_at_once() const { return columns_.size(); }
  /// Adds the counts of another problem, and its last reason.
  void count_in(const ShootingProblem& other);
  std::uint64_t simulations() const { return simulations_; }
  std::uint64_t invalid_simulations() const { return invalid_; }
  const std::string& last_reason() const { return reason_; }

 private:
  /// One column of the Jacobian of one segment.
  struct Column {
    std::size_t segment;
    Eigen::Index index;  ///< a shared value, or after them an unknown of the segment's state
  };

  /// Base of the differences.
  struct Origin {
    const FitPoint& point;
    const std::vector<Eigen::VectorXd>& residuals;  ///< at that point
  };

  bool segment_residuals(std::size_t k, const Eigen::VectorXd& values, const Eigen::VectorXd& state, int worker,
                         Eigen::VectorXd& residuals);
  std::size_t kind(const Column& column) const;
  bool is_shared(const Column& column) const { return column.index < space_.size(); }
  /// Of these columns, with steps that follow the residual.
  void differentiate(const Origin& origin, std::vector<Column> columns, std::vector<SegmentJacobian>& jacobians);
  void difference(const Origin& origin, const std::vector<Column>& columns, bool central,
                  std::vector<SegmentJacobian>& jacobians);
  bool difference_column(const Origin& origin, const Column& column, bool central, int worker,
                         Eigen::Ref<Eigen::VectorXd> derivative);
  std::vector<bool> adapt_steps(const std::vector<SegmentJacobian>& jacobians, const std::vector<Column>& columns,
                                double target);
  double largest_step(std::size_t kind) const;
  /// The smallest channel noise in whitened units.
  double noise_over_scale() const;

  const TrialPredictor& predictor_;
  const ParameterSpace& space_;
  std::vector<Segment> segments_;
  const std::vector<ChannelNoise>& noise_;
  std::vector<std::vector<std::size_t>> channel_of_;  ///< per trial and measured column: index into the noise list
  std::vector<double> scales_;
  std::vector<double> steps_;  ///< of differences: shared values, then the components of a start state
  std::vector<Column> columns_;
  std::vector<Prediction> predictions_;  ///< one a worker
  std::size_t samples_ = 0;
  std::atomic<std::uint64_t> simulations_{0}, invalid_{0};
  std::string reason_;
};

/// One scale per channel, from residuals whitened by the problem's scales: 1.4826 × their median size, or with the
/// squared loss their RMS; at least the channel's noise.
std::vector<double> residual_scales(const ShootingProblem& problem, const std::vector<Eigen::VectorXd>& residuals,
                                    const RobustLoss& loss);

}  // namespace lacuna
