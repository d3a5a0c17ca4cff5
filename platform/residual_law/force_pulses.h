#pragma once

#include "residual_law/joint_course.h"
#include "search/fitted_models.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// What short forces on one joint do to the predictions of a fitted model, to first order.
struct ForcePulses {
  /// By stretch: what a unit of force adds to the prediction, over a reading's standard deviation; rows × pulses.
  std::vector<Eigen::MatrixXd> responses;
  /// By stretch and pulse: the samples of the stretch that it covers, first and behind the last.
  std::vector<std::vector<std::pair<Eigen::Index, Eigen::Index>>> samples;
};

/// At the values and starts where the model was fitted. No responses where it cannot be simulated with a force.
ForcePulses force_pulses(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder,
                         const JointCourse& joint);

}  // namespace lacuna
