#pragma once

#include "residual_law/joint_course.h"

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// Functions of the motion of one joint whose weighted sum is a force of one kind.
struct LawFamily {
  std::string kind;  ///< the quantities that the force depends on: "position", "velocity and its past", ...
  std::vector<std::function<double(const JointMoment&)>> functions;
  /// Families of one quantity: the points of its curve, and the sample that stands for each. Else none.
  std::string quantity = {}, unit = {};
  std::vector<double> places = {};
  double JointMoment::*of = nullptr;
  /// Depends on the velocity, now or before: friction of this kind takes energy from the joint.
  bool follows_velocity = false;
};

/// The kinds of force on a joint: of position (piecewise linear between knots at quantiles; periodic on a hinge); of
/// velocity, with a jump at zero; of command; of time; of position and velocity together, and damping that is periodic
/// in the position; of the past of velocity and direction; of the past of the command (a delay); of command and
/// velocity together; of command and time, and of velocity and time (a drift).
std::vector<LawFamily> law_families(const JointCourse& course);

/// A physical term of a force law.
struct ForceTerm {
  std::string text;  ///< in the language of formulas (docs/reference/formulas.md), such as "v*abs(v)"
  std::string unit;  ///< of the term: rad^2/s^2
  std::function<double(const JointMoment&)> of;
};

/// Terms of physical laws with scales from the motion of the joint: powers, products with directions, sines of the
/// position, friction that fades with speed or grows with the load. Terms of the command only where there are commands.
std::vector<ForceTerm> force_terms(const JointCourse& course);

}  // namespace lacuna
