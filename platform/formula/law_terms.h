#pragma once

#include "formula/expression.h"

#include <string>
#include <vector>

namespace lacuna {

/// A summand of a formula: number × factors.
struct RawTerm {
  double number = 1.0;
  std::vector<Expression> over, under;  ///< factors and divisors other than numbers
  int column = 0;

  /// The product without its number: "v*abs(v)"; "1" if there are no other factors.
  Expression rest() const;
};

/// The summands of a formula, in order. Parentheses inside are not multiplied out.
std::vector<RawTerm> terms_of(const Expression& formula);

/// A name for the coefficient of a term: c_v_abs_v for "v*abs(v)", "constant" for "1"; empty if the term is too long.
std::string name_of_factor(const Expression& rest);

}  // namespace lacuna
