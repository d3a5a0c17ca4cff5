#pragma once

#include "residual_law/joint_course.h"
#include "search/fitted_models.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// First-order response of the predictions of a fitted model to short forces on one joint.
struct ForcePulses {
  /// By stretch: what a unit of force adds to the prediction, over a reading's standard deviation; rows × pulses.
  std::vector<Eigen::MatrixXd> responses;
  /// By stretch and pulse: the first sample of the stretch that the pulse covers, and one past the last.
  std::vector<std::vector<std::pair<Eigen::Index, Eigen::Index>>> samples;
};

/// At the fitted values and initial states. No responses where the model cannot be simulated with a force.
ForcePulses force_pulses(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder,
                         const JointCourse& joint);

}  // namespace lacuna
