#pragma once

#include "diagnosis/residual_force/joint_motion.h"

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// A physical term of a force law: a function of a joint's position q, velocity v and command u.
struct ForceFeature {
  std::string text;  ///< in the language of formulas (docs/reference/formulas.md), such as "v*abs(v)"
  std::string unit;  ///< of the term: rad^2/s^2
  std::function<double(double q, double v, double u)> of;
};

/// Terms that physical laws are made of, with scales taken from how the joint moved: powers, products with directions,
/// sines of the position, friction that fades with speed or grows with the load. Commands only where there are any.
std::vector<ForceFeature> force_features(const JointMotion& motion);

}  // namespace lacuna
