#pragma once

#include "diagnosis/refit/cross_validation.h"
#include "diagnosis/residual_force/force_task.h"
#include "diagnosis/residual_force/joint_motion.h"

#include <string>
#include <vector>

namespace lacuna {

/// A force law of a few physical terms that explains what a model leaves of one joint's motion.
struct ForceFormula {
  struct Term {
    std::string text;                                ///< such as "v*abs(v)"
    std::string unit;                                ///< of the text
    double coefficient = 0.0, standard_error = 0.0;  ///< force unit over `unit`
    bool operator==(const Term&) const = default;
  };
  std::string joint;
  std::string unit;  ///< of the force, N*m or N
  std::vector<Term> terms;
  Gain gain;                      ///< held out, over the model without it
  Eigen::VectorXd held_out = {};  ///< deviance by block, as of a rival

  /// Such as "-0.0213*v*abs(v) + 0.4*sgn(v)"; the force on the joint.
  std::string text() const;
};

/// Sparse regression: terms of one joint enter one by one, each the one that predicts the left-out folds best, while
/// that gains more than chance lets it. Returns a formula a joint, the largest gain first, without the joints of which
/// no term gains.
///
/// Literature: S. L. Brunton, J. L. Proctor and J. N. Kutz, PNAS 113 (2016) 3932-3937 (sparse regression over
/// candidate terms); here the terms pass through the model's own sensitivities, so that nothing is differentiated.
std::vector<ForceFormula> find_formulas(const ForceTask& task, const std::vector<JointMotion>& motions,
                                        const ForceResponses& forces);

}  // namespace lacuna
