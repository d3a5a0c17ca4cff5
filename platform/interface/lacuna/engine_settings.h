#pragma once

#include <string>

namespace lacuna {

/// Whether delays are exact or rounded to whole integration steps (like the seed's lags).
enum class DelayRounding { none, step };

/// How a model is integrated; part of a revision's digest.
struct EngineSettings {
  std::string engine = {};  ///< "articulated", "ode"; empty: the first that can move the robot
  double step = 0.001;      ///< s; controllers act at step ends, rounded delays are multiples of the step
  int substeps = 0;  ///< integration steps per step: h = step/substeps; sensors and effects are evaluated each h; 0:
                     ///< automatic, which is 1 until substeps are determined (fitting/substeps.h)
  double control_period = 0.0;  ///< s, interval between controller calls; 0: every step
  double joint_erp = 0.2;       ///< share of a joint's position error that is corrected in one integration step, 1
  DelayRounding delay_rounding = DelayRounding::none;
};

}  // namespace lacuna
