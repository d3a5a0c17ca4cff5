#pragma once

#include <string>

namespace lacuna {

/// Whether delays act as they are or are rounded to whole integration steps (as the seed's lags).
enum class DelayRounding { none, step };

/// How a model is integrated; part of a revision's digest.
struct EngineSettings {
  std::string engine = {};  ///< "articulated", "ode"; empty: the first that can move the robot
  double step = 0.001;      ///< s; controllers act at its ends, rounded delays are multiples of it
  int substeps = 0;         ///< integration steps in a step: h = step/substeps; sensors and effects are seen each h;
                            ///< 0: as many as needed, which are one where nobody has found out (fitting/substeps.h)
  double control_period = 0.0;  ///< s, how often a controller acts; 0: every step
  double joint_erp = 0.2;       ///< share of a joint's error that is corrected in one integration step, 1
  DelayRounding delay_rounding = DelayRounding::none;
};

}  // namespace lacuna
