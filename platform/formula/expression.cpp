#include "formula/expression.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

using Kind = Expression::Kind;

enum Precedence { kSum = 1, kProduct, kNegation, kPower, kLeaf };

Precedence precedence(const Expression& expression) {
  switch (expression.kind) {
    case Kind::sum:
    case Kind::difference: return kSum;
    case Kind::product:
    case Kind::quotient: return kProduct;
    case Kind::negation: return kNegation;
    case Kind::power: return kPower;
    case Kind::number: return expression.number < 0.0 ? kNegation : kLeaf;
    case Kind::variable:
    case Kind::parameter:
    case Kind::call: break;
  }
  return kLeaf;
}

class Writer {
 public:
  explicit Writer(const ExpressionStyle& style) : style_(style) {}

  std::string write(const Expression& e) const {
    switch (e.kind) {
      case Kind::number: return style_.number(e.number);
      case Kind::variable: return e.name;
      case Kind::parameter: return style_.parameter(e.name);
      case Kind::negation: return "-" + at_least(kPower, e.parts[0]);
      case Kind::sum: return binary(e, " + ", kSum, kProduct);
      case Kind::difference: return binary(e, " - ", kSum, kProduct);
      case Kind::product: return binary(e, style_.cpp ? " * " : "*", kProduct, kPower);
      case Kind::quotient: return binary(e, style_.cpp ? " / " : "/", kProduct, kPower);
      case Kind::power: return power(e);
      case Kind::call: break;
    }
    return e.name + "(" + write(e.parts[0]) + ")";
  }

 private:
  std::string at_least(Precedence least, const Expression& e) const {
    return precedence(e) < least ? "(" + write(e) + ")" : write(e);
  }
  std::string binary(const Expression& e, const char* sign, Precedence left, Precedence right) const {
    return at_least(left, e.parts[0]) + sign + at_least(right, e.parts[1]);
  }
  std::string power(const Expression& e) const {
    if (style_.cpp) return "pow(" + write(e.parts[0]) + ", " + write(e.parts[1]) + ")";
    return at_least(kLeaf, e.parts[0]) + "^" + at_least(kLeaf, e.parts[1]);
  }

  const ExpressionStyle& style_;
};

}  // namespace

bool Expression::is_call_of(const std::string& function, const std::string& variable) const {
  return kind == Kind::call && name == function && parts[0].kind == Kind::variable && parts[0].name == variable;
}

std::string written(const Expression& expression, const ExpressionStyle& style) {
  return Writer(style).write(expression);
}

std::string formula_text(const Expression& expression) {
  return written(expression, {.number = number_text, .parameter = [](const std::string& name) { return name; }});
}

std::string number_text(double number) { return fmt::format("{}", number); }

void walk(const Expression& expression, const std::function<void(const Expression&)>& visit) {
  visit(expression);
  for (const Expression& part : expression.parts) walk(part, visit);
}

}  // namespace lacuna
