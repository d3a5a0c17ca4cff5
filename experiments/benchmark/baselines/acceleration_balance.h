#pragma once

#include "baselines/recorded_motion.h"

namespace hidden_effects {

/// Inverse dynamics: what a model's drives, laws, springs and weight exert on the joints in a recorded motion, less
/// inertia times acceleration, and this divided by the inertia, rad/s² or m/s²: samples × joints, zero for a right
/// model and exact readings. (In torques a drive whose gain is free would balance best with no gain at all; and it is
/// the twice differentiated readings whose noise is in it.) Laws with a memory are carried through the motion sample by
/// sample; friction's sign is softened around standstill, where readings do not tell it.
///
/// Empty where positions of joints do not tell the balance: with an elastic transmission, whose rotor nobody reads.
Eigen::MatrixXd acceleration_balance(const PlantModel& model, const Eigen::VectorXd& values,
                                     const Excitation& excitation, const RecordedMotion& motion);

}  // namespace hidden_effects
