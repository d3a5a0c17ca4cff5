#pragma once

#include "residual_law/joint_course.h"

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// Functions of what a joint does whose sum is a force of one kind.
struct LawFamily {
  std::string kind;  ///< what the force goes with: "position", "velocity and its past", ...
  std::vector<std::function<double(const JointMoment&)>> functions;
  /// Of one quantity: where a curve of it is told, and the moment that stands for each place. Else none.
  std::string quantity = {}, unit = {};
  std::vector<double> places = {};
  double JointMoment::*of = nullptr;
  bool follows_velocity = false;  ///< now or before: friction of this kind takes energy from the joint
};

/// The kinds of force that a joint may feel: of position (by hats between knots at quantiles, and periodic on a hinge),
/// of velocity, with a jump where it is none, of command and of time; of position and velocity together, damping that
/// is periodic in the position; of the past of velocity and direction; of the past of the command, which is late; of
/// command and velocity together; of the command and the time, and the velocity and the time, which drift.
std::vector<LawFamily> law_families(const JointCourse& course);

/// A physical term of a force law.
struct ForceTerm {
  std::string text;  ///< in the language of formulas (docs/reference/formulas.md), such as "v*abs(v)"
  std::string unit;  ///< of the term: rad^2/s^2
  std::function<double(const JointMoment&)> of;
};

/// Terms that physical laws are made of, with scales taken from how the joint moved: powers, products with directions,
/// sines of the position, friction that fades with speed or grows with the load. Commands only where there are any.
std::vector<ForceTerm> force_terms(const JointCourse& course);

}  // namespace lacuna
