#pragma once

#include "diagnosis/noise/whitened.h"
#include "diagnosis/residual_force/force_task.h"
#include "diagnosis/residual_force/joint_motion.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A part of a free force: what it is where one quantity of a joint is so large, linear between.
struct ForceCurve {
  std::string joint;
  std::string of;    ///< position, velocity or command
  std::string unit;  ///< of that quantity
  std::string force_unit;
  std::vector<double> at, force, standard_error;
  /// Of a slice: the whole force where the joint is at this position. Without it: what this quantity alone adds.
  std::optional<double> position = {};
  bool operator==(const ForceCurve&) const = default;
};

/// A force on the joints of any form: a sum of functions of a joint's position, velocity and command, each linear
/// between knots, and of products of position and velocity. What it explains and no effect of the library does is
/// missing from the library.
struct FreeForce {
  /// By segment, bins × functions: change of the prediction by each function at size 1.
  std::vector<Eigen::MatrixXd> columns;
  std::vector<ForceCurve> curves;  ///< where the force is to be told only: of each quantity, then slices of each joint
  std::vector<Eigen::Index> pieces;  ///< by segment, of half a second at most
  Eigen::MatrixXd readings;          ///< places of the curves, one after the other × functions
  bool empty() const { return curves.empty(); }
};

FreeForce free_force(const std::vector<JointMotion>& motions, const ForceResponses& forces);

/// Whether the free force explains more than noise does.
struct FreeForceTest {
  double deviance = 0.0;  ///< by how much −2 log likelihood falls
  int freedom = 0;        ///< independent functions that can be seen
  /// How often noise explains as much, pieces of segments pushed either way at random; at least 1/(draws + 1).
  double p = 1.0;
  double p_low = 1.0, p_high = 1.0;  ///< were the deviance as much more, or less, as last digits may make it
  /// Held-out deviance by block, folds left out one by one; ridge by cross-validation.
  Eigen::VectorXd held_out;
  std::vector<ForceCurve> curves;  ///< told
};
FreeForceTest test_free_force(const ForceTask& task, const WhitenedSegments& whitened, const FreeForce& force);

}  // namespace lacuna
