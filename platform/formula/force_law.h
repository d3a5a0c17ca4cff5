#pragma once

#include "formula/expression.h"

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// A number of a force law that a fit may change.
struct LawParameter {
  std::string name;
  std::string unit;  ///< in the words of effects: {force}, {position}, {command} (lacuna/physical_effect.h)
  double start = 0.0, lower = 0.0, upper = 0.0;
  double neutral = 0.0;      ///< the law is zero where all parameters are at theirs
  bool logarithmic = false;  ///< it scales something and keeps its sign
  std::string description;
};

/// A summand of a force law.
struct LawTerm {
  Expression value;           ///< with its parameter; without sgn(v) if `along_motion`
  bool along_motion = false;  ///< the term is `value`*sgn(v): dry friction where `value` is negative
};

/// The force on a joint as a function of its position q, velocity v and its actuator's command u.
struct ForceLaw {
  std::string text;  ///< the formula as given, on one line
  bool uses_command = false;
  std::vector<LawParameter> parameters;
  std::vector<LawTerm> terms;
  std::vector<std::string> notes;  ///< sentences on what a reader of the formula may not expect

  /// "c_v*v + c_sgn_v*sgn(v)".
  std::string equation() const;
};

/// Reads a formula (docs/reference/formulas.md) as a sum of terms. The number of a term becomes a parameter that starts
/// there and may go to a hundred times its size either way; so does a name that multiplies a term, in place of its
/// number, and starts at its value in `values`. Names inside of terms are parameters too. Throws `BadInput` with all
/// problems and their places.
ForceLaw read_force_law(const std::string& formula, const std::map<std::string, double>& values);

}  // namespace lacuna
