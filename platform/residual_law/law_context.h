#pragma once

#include "residual_law/force_pulses.h"
#include "residual_law/law_family.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// A force on one joint, the sum of some candidate functions, fitted together with the values of a model.
struct FittedLaw {
  std::string kind;
  std::vector<std::size_t> functions;
  double ridge = 0.0;
  LinearCost fit;  ///< its step: the model's values, then the coefficients of the functions, N*m or N
  CandidateSet judged;
};

/// Candidate functions of the motion of one joint as forces on it, beside a fitted model; all to first order.
class LawContext {
 public:
  using Functions = std::vector<std::function<double(const JointMoment&)>>;

  /// `linear`: the model linearised on the ladder, at its fitted values and initial states.
  LawContext(const PredictionLadder& ladder, const LinearPrediction& linear, const StepBounds& bounds,
             const JointCourse& course, const ForcePulses& pulses, const Functions& functions);

  /// Without functions: the model itself.
  FittedLaw fit(const std::string& kind, const std::vector<std::size_t>& functions, double ridge) const;
  /// With each of these ridges.
  std::vector<FittedLaw> fits(const std::string& kind, const std::vector<std::size_t>& functions,
                              std::span<const double> ridges) const;
  /// Covariance of the coefficients (criterion/value_errors.h).
  Eigen::MatrixXd covariance(const FittedLaw& law) const;
  /// The coefficients of the functions.
  Eigen::VectorXd sizes(const FittedLaw& law) const;

 private:
  BlockProducts products_of(const std::vector<std::size_t>& functions) const;
  StepBounds bounds_of(const FittedLaw& law) const;

  const CellLayout& layout_;
  StepBounds bounds_;  ///< of the model's values
  BlockProducts products_;
};

}  // namespace lacuna
