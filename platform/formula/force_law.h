#pragma once

#include <lacuna/parameter.h>

#include "formula/expression.h"

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// A number of a force law that a fit may change. Units in placeholders of effects (lacuna/physical_effect.h).
struct LawParameter : ParameterDeclaration {
  double neutral = 0.0;  ///< value at which, with all parameters at theirs, the law is zero
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
  std::vector<std::string> notes;  ///< notes on properties of the formula that may surprise

  /// "c_v*v + c_sgn_v*sgn(v)".
  std::string equation() const;
};

/// Reads a formula (docs/reference/formulas.md) as a sum of terms. The number of a term becomes a parameter that starts
/// there, with bounds at a hundred times its size in both directions; so does a name that multiplies a term, which
/// starts at its value in `values`. Names inside terms are parameters, too. Throws `BadInput` with all problems and
/// their places.
ForceLaw read_force_law(const std::string& formula, const std::map<std::string, double>& values);

}  // namespace lacuna
