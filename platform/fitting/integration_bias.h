#pragma once

#include "evaluation/model/model_definition.h"
#include "fitting/intervals/covariance.h"
#include "fitting/shooting/refinement.h"
#include "fitting/starts/start_states.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Change of a fitted value by the integration error.
struct ValueShift {
  std::string address;  ///< address of the value that changes most; empty: none
  double share = 0.0;   ///< of half its 95 % interval
};

/// Bias of fitted values by the integration. A few cheap stages bring the values near the result of a fit; there the
/// linear least squares of the last stage give their change when the integration steps are halved, and the width of
/// their intervals. Everything that it refers to must outlive the use.
class IntegrationBias {
 public:
  /// `trials`: some of `all` trials that the fit will use; the number of all sets the intervals. `substeps`: for this
  /// estimate of the values.
  IntegrationBias(const ModelDefinition& definition, const FitSection& options, const std::vector<Trial>& trials,
                  std::size_t all, std::vector<double> values, int substeps, const Work& work);
  ~IntegrationBias();

  /// Near the result of a fit; none where the model cannot be simulated.
  std::vector<double> values() const { return problem_ ? space_.to_values(point_.values) : std::vector<double>(); }
  /// For the value that changes most by the error of so many substeps; nothing where the model cannot be simulated.
  std::optional<ValueShift> with(int substeps) const;

 private:
  struct Solution;
  std::vector<Eigen::VectorXd> residuals(int substeps) const;
  bool approach(const FitSection& options, std::vector<double> values);
  ValueShift largest(const Eigen::VectorXd& shifts) const;

  const ModelDefinition& definition_;
  ParameterSpace space_;
  std::vector<ChannelNoise> noise_;
  Work work_;
  double trials_share_;
  RobustLoss loss_;
  std::unique_ptr<Solution> base_;
  std::unique_ptr<ShootingProblem> problem_;  ///< null: the model cannot be simulated
  FitPoint point_;
  std::vector<SegmentJacobian> jacobians_;
  std::vector<Eigen::VectorXd> at_base_;
  Uncertainty known_;
};

}  // namespace lacuna
