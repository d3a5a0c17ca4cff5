#pragma once

#include <Eigen/Core>

namespace lacuna {

/// A Butterworth low-pass of second order, once forwards and once backwards: no phase, and half the amplitude at
/// `cutoff` Hz. Samples are `interval` s apart; each pass starts at rest at the first value it meets.
Eigen::VectorXd low_passed(const Eigen::VectorXd& values, double interval, double cutoff);

}  // namespace lacuna
