#pragma once

#include "residual_law/gain.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A force that no effect has: what it is where one quantity of a joint is so large, linear between.
struct ForceCurve {
  std::string joint;
  std::string of;    ///< position, velocity, command or time
  std::string unit;  ///< of that quantity
  std::string force_unit;
  std::vector<double> at, force, standard_error;
  /// Of a slice: the whole force where the joint is at this position. Without it: what this quantity alone adds.
  std::optional<double> position = {};
  std::vector<double> by_answer = {};  ///< what the answer makes of it, at the same places; empty: not asked
  bool operator==(const ForceCurve&) const = default;
};

/// That a force is left which no effect has.
struct UnexplainedForce {
  std::string joint;
  std::string depends_on;  ///< "velocity", "the past of the command" (law_family.h)
  double share = 0.0;      ///< of all that the answer and this force gain together
  Gain gain;               ///< where it was not fitted, over the answer
  bool operator==(const UnexplainedForce&) const = default;
};

/// A force law of a few physical terms that explains what a model leaves of one joint's motion.
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
  Gain gain;  ///< where it was not fitted, over the model without it

  /// Such as "-0.0213*v*abs(v) + 0.4*sgn(v)"; the force on the joint.
  std::string text() const;
};

}  // namespace lacuna
