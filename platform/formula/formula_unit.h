#pragma once

#include "formula/expression.h"

#include <array>
#include <map>
#include <string>

namespace lacuna {

/// Exponents of the joint's position, of seconds and of the actuator's command.
using FormulaDimension = std::array<int, 3>;

/// The dimension of an expression: a number inside it has any unit that makes sums and arguments consistent, as 0.05 in
/// exp(-(v/0.05)^2); a sum has that of its first summand with a variable. An expression without whole exponents below
/// ten, such as sqrt(abs(v)), counts as a number of SI units.
FormulaDimension dimension_of(const Expression& expression);

/// The unit of a coefficient that turns an expression of that dimension into a force, in placeholders of effects
/// (lacuna/physical_effect.h): "{force}*s^2/{position}^2" for v*abs(v).
std::string unit_of_factor(const FormulaDimension& of);

/// The unit of that dimension itself: "{position}/s", "1".
std::string unit_of(const FormulaDimension& dimension);

/// For each parameter that is a divisor or summand, the dimension that the other side gives it, once per place.
std::multimap<std::string, FormulaDimension> inner_dimensions(const Expression& expression);

}  // namespace lacuna
