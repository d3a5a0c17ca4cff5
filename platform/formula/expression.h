#pragma once

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// A formula as a tree. Leaves are numbers, the variables q, v and u, and named parameters.
struct Expression {
  enum class Kind { number, variable, parameter, negation, sum, difference, product, quotient, power, call };
  Kind kind = Kind::number;
  double number = 0.0;            ///< of a number
  std::string name;               ///< of a variable, a parameter or a called function
  std::vector<Expression> parts;  ///< operands; for a power, the base and its exponent, a number
  int column = 0;                 ///< position in the text, from 1

  bool is_number() const { return kind == Kind::number; }
  /// Whether it is `function(variable)`, such as sgn(v).
  bool is_call_of(const std::string& function, const std::string& variable) const;
};

/// How an expression is written: as a formula or as C++.
struct ExpressionStyle {
  std::function<std::string(double)> number;
  std::function<std::string(const std::string&)> parameter;
  bool cpp = false;  ///< a * b and pow(a, b) instead of a*b and a^b
};

/// The expression as text, with as few parentheses as possible.
std::string written(const Expression& expression, const ExpressionStyle& style);

/// The expression in the language of formulas.
std::string formula_text(const Expression& expression);

/// The shortest text that reads back as the same number.
std::string number_text(double number);

/// Calls `visit` for the expression and everything below it, parents first.
void walk(const Expression& expression, const std::function<void(const Expression&)>& visit);

}  // namespace lacuna
