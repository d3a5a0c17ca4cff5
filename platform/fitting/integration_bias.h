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

/// How far the integration error moves a fitted value.
struct ValueShift {
  std::string address;  ///< of the value that is moved most; empty: none is
  double share = 0.0;   ///< of half its 95 % interval
};

/// What integration does to the values of a fit. A few cheap stages bring the values near those that the fit will find;
/// there the last stage's linear least squares say how far they move when the integration steps are halved, and how
/// wide their intervals are. Everything referred to must outlive the use.
class IntegrationBias {
 public:
  /// `trials`: some of `all` trials that the fit will use, whose number the intervals follow. `substeps`: with which
  /// the values are looked for.
  IntegrationBias(const ModelDefinition& definition, const FitSection& options, const std::vector<Trial>& trials,
                  std::size_t all, std::vector<double> values, int substeps, int threads);
  ~IntegrationBias();

  /// Near those that the fit will find; none where the model cannot be simulated.
  std::vector<double> values() const { return problem_ ? space_.to_values(point_.values) : std::vector<double>(); }
  /// Of the value that is moved most by the error that so many substeps leave; nothing where the model cannot be
  /// simulated.
  std::optional<ValueShift> with(int substeps) const;

 private:
  struct Solution;
  std::vector<Eigen::VectorXd> residuals(int substeps) const;
  bool approach(const FitSection& options, std::vector<double> values);
  ValueShift largest(const Eigen::VectorXd& shifts) const;

  const ModelDefinition& definition_;
  ParameterSpace space_;
  std::vector<ChannelNoise> noise_;
  int threads_;
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
