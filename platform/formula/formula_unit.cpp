#include "formula/formula_unit.h"

#include <cmath>
#include <cstdlib>

namespace lacuna {
namespace {

using Kind = Expression::Kind;

constexpr int kLargestExponent = 9;  ///< in a unit
constexpr FormulaDimension kNone = {0, 0, 0};

FormulaDimension combined(const FormulaDimension& a, const FormulaDimension& b, int sign) {
  return {a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]};
}

/// To a power; a plain number where exponents would not be small whole numbers.
FormulaDimension raised(const FormulaDimension& base, double exponent) {
  FormulaDimension result;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const double product = base[i] * exponent;
    if (product != std::floor(product) || std::abs(product) > kLargestExponent) return kNone;
    result[i] = static_cast<int>(product);
  }
  return result;
}

/// "*s^2", "/s^2" or nothing.
std::string factor(const std::string& unit, int exponent) {
  if (exponent == 0) return {};
  const int size = std::abs(exponent);
  return (exponent > 0 ? "*" : "/") + unit + (size > 1 ? "^" + std::to_string(size) : "");
}

/// A command's unit may be a product: in a denominator it gets parentheses.
std::string command_factor(int exponent) {
  return exponent > 0 ? "/{command}^-" + std::to_string(exponent) : factor("{command}", exponent);
}

}  // namespace

FormulaDimension dimension_of(const Expression& e) {
  switch (e.kind) {
    case Kind::variable:
      return e.name == "q"   ? FormulaDimension{1, 0, 0}
             : e.name == "v" ? FormulaDimension{1, -1, 0}
                             : FormulaDimension{0, 0, 1};
    case Kind::negation: return dimension_of(e.parts[0]);
    case Kind::sum:
    case Kind::difference: {
      const FormulaDimension first = dimension_of(e.parts[0]);
      return first == kNone ? dimension_of(e.parts[1]) : first;
    }
    case Kind::product: return combined(dimension_of(e.parts[0]), dimension_of(e.parts[1]), 1);
    case Kind::quotient:
      if (e.parts[1].kind == Kind::parameter || e.parts[1].is_number()) return dimension_of(e.parts[0]);
      return combined(dimension_of(e.parts[0]), dimension_of(e.parts[1]), -1);
    case Kind::power: return raised(dimension_of(e.parts[0]), e.parts[1].number);
    case Kind::call:
      if (e.name == "abs") return dimension_of(e.parts[0]);
      return e.name == "sqrt" ? raised(dimension_of(e.parts[0]), 0.5) : kNone;
    case Kind::number:
    case Kind::parameter: break;
  }
  return kNone;
}

std::string unit_of_factor(const FormulaDimension& of) {
  return "{force}" + (of[1] < 0 ? factor("s", -of[1]) : "") + factor("{position}", -of[0]) +
         (of[1] > 0 ? factor("s", -of[1]) : "") + command_factor(-of[2]);
}

std::string unit_of(const FormulaDimension& dimension) {
  const std::string text =
      factor("{position}", dimension[0]) + command_factor(dimension[2]) + factor("s", dimension[1]);
  if (text.empty()) return "1";
  return text.front() == '*' ? text.substr(1) : "1" + text;
}

std::multimap<std::string, FormulaDimension> inner_dimensions(const Expression& expression) {
  std::multimap<std::string, FormulaDimension> found;
  walk(expression, [&](const Expression& e) {
    const auto pair_up = [&](const Expression& name, const Expression& other) {
      if (name.kind == Kind::parameter) found.emplace(name.name, dimension_of(other));
    };
    if (e.kind == Kind::quotient) pair_up(e.parts[1], e.parts[0]);
    if (e.kind != Kind::sum && e.kind != Kind::difference) return;
    pair_up(e.parts[0], e.parts[1]);
    pair_up(e.parts[1], e.parts[0]);
  });
  return found;
}

}  // namespace lacuna
