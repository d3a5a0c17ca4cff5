#pragma once

#include "residual_law/gain.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A nonparametric residual force over one quantity of a joint, linear between the points.
struct ForceCurve {
  std::string joint;
  std::string of;    ///< position, velocity, command or time
  std::string unit;  ///< of that quantity
  std::string force_unit;
  std::vector<double> at, force, standard_error;
  /// Of a slice: the whole force at this position of the joint. Without it: the part of the force that this quantity
  /// alone adds.
  std::optional<double> position = {};
  std::vector<double> by_answer = {};  ///< the part that the answer explains, at the same points; empty: not asked
  bool operator==(const ForceCurve&) const = default;
};

/// A residual force remains that no effect describes.
struct UnexplainedForce {
  std::string joint;
  std::string depends_on;  ///< "velocity", "the past of the command" (law_family.h)
  double share = 0.0;      ///< share of the gain of the answer and this force together
  Gain gain;               ///< on data to which it was not fitted, over the answer
  bool operator==(const UnexplainedForce&) const = default;
};

/// A force law of a few physical terms for the residual force on one joint.
struct ForceFormula {
  struct Term {
    std::string text;                                ///< such as "v*abs(v)"
    std::string unit;                                ///< of the text
    double coefficient = 0.0, standard_error = 0.0;  ///< force unit over `unit`
    bool operator==(const Term&) const = default;
  };
  std::string joint;
  std::string unit;  ///< of the force, N*m or N
  std::vector<Term> terms;
  Gain gain;  ///< on data to which it was not fitted, over the model without it

  /// Such as "-0.0213*v*abs(v) + 0.4*sgn(v)"; the force on the joint.
  std::string text() const;
};

}  // namespace lacuna
