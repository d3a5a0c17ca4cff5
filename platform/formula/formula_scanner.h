#pragma once

#include "foundation/text/problem.h"

#include <string>
#include <vector>

namespace lacuna {

/// A word of a formula.
struct FormulaToken {
  enum class Kind { number, name, sign, end };
  Kind kind = Kind::end;
  std::string text;     ///< a sign is one of + - * / ^ ( )
  double number = 0.0;  ///< of a number
  int column = 0;       ///< of its first character, from 1
};

/// A place in a formula, as messages name it.
SourceLocation formula_place(int column);

/// Splits a formula into words, the last of which is its end. Invalid characters go to `problems` and are left out.
std::vector<FormulaToken> scan_formula(const std::string& text, ProblemList& problems);

}  // namespace lacuna
