#include "formula/formula_checks.h"

#include "formula/formula_scanner.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using Kind = Expression::Kind;

bool is_whole(double number) { return number == std::floor(number); }
bool is_even(double number) { return is_whole(0.5 * number); }

class Signs {
 public:
  explicit Signs(const std::set<std::string>& positive) : positive_(positive) {}

  bool never_negative(const Expression& e) const {
    const auto part = [&](const Expression& p) { return never_negative(p); };
    switch (e.kind) {
      case Kind::number: return e.number >= 0.0;
      case Kind::parameter: return positive_.contains(e.name);
      case Kind::sum:
      case Kind::product: return std::all_of(e.parts.begin(), e.parts.end(), part) || is_square(e);
      case Kind::quotient: return std::all_of(e.parts.begin(), e.parts.end(), part);
      case Kind::power: return is_even(e.parts[1].number) || never_negative(e.parts[0]);
      case Kind::call: return e.name == "abs" || e.name == "sqrt" || e.name == "exp";
      case Kind::variable:
      case Kind::negation:
      case Kind::difference: break;
    }
    return false;
  }

  bool always_positive(const Expression& e) const {
    const auto part = [&](const Expression& p) { return always_positive(p); };
    switch (e.kind) {
      case Kind::number: return e.number > 0.0;
      case Kind::parameter: return positive_.contains(e.name);
      case Kind::sum:
        return std::any_of(e.parts.begin(), e.parts.end(), part) &&
               std::all_of(e.parts.begin(), e.parts.end(), [&](const Expression& p) { return never_negative(p); });
      case Kind::product:
      case Kind::quotient: return std::all_of(e.parts.begin(), e.parts.end(), part);
      case Kind::power: return always_positive(e.parts[0]);
      case Kind::call: return e.name == "exp" || ((e.name == "abs" || e.name == "sqrt") && always_positive(e.parts[0]));
      case Kind::variable:
      case Kind::negation:
      case Kind::difference: break;
    }
    return false;
  }

  bool never_zero(const Expression& e) const {
    if (e.is_number()) return e.number != 0.0;
    return e.kind == Kind::negation ? never_zero(e.parts[0]) : always_positive(e);
  }

 private:
  static bool is_square(const Expression& e) {
    return e.kind == Kind::product && formula_text(e.parts[0]) == formula_text(e.parts[1]);
  }

  const std::set<std::string>& positive_;
};

}  // namespace

void check_finite(const Expression& formula, const std::set<std::string>& positive, ProblemList& problems) {
  const Signs signs(positive);
  const auto refuse_divisor = [&](const Expression& divisor) {
    problems.add(formula_place(divisor.column), formula_text(divisor) +
                                                    " may be zero, so dividing by it may give infinity; divide by a "
                                                    "positive expression, as in q/(0.01 + abs(v)) or q*exp(-abs(v))");
  };
  walk(formula, [&](const Expression& e) {
    if (e.kind == Kind::quotient && !signs.never_zero(e.parts[1])) refuse_divisor(e.parts[1]);
    if (e.kind == Kind::power) {
      const Expression& base = e.parts[0];
      if (e.parts[1].number < 0.0 && !signs.never_zero(base)) refuse_divisor(base);
      if (!is_whole(e.parts[1].number) && !signs.never_negative(base))
        problems.add(formula_place(e.column), formula_text(base) + " may be negative and then has no power of " +
                                                  number_text(e.parts[1].number) +
                                                  "; write it with abs(...), as in sgn(v)*abs(v)^1.5");
    }
    if (e.kind == Kind::call && e.name == "sqrt" && !signs.never_negative(e.parts[0]))
      problems.add(formula_place(e.column),
                   formula_text(e.parts[0]) +
                       " may be negative and then has no root; write it with abs(...), as in sgn(v)*sqrt(abs(v))");
  });
}

}  // namespace lacuna
