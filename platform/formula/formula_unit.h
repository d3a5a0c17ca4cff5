#pragma once

#include "formula/expression.h"

#include <array>
#include <map>
#include <string>

namespace lacuna {

/// Exponents of the joint's position, of seconds and of the actuator's command.
using FormulaDimension = std::array<int, 3>;

/// The dimension of an expression: a number inside it has whatever unit makes sums and arguments fit, as 0.05 in
/// exp(-(v/0.05)^2); a sum has that of its first summand with a variable. What has no whole exponents below ten,
/// such as sqrt(abs(v)), counts as a number of SI units.
FormulaDimension dimension_of(const Expression& expression);

/// The unit of a number that makes a force of an expression of that dimension, in the words of effects
/// (lacuna/physical_effect.h): "{force}*s^2/{position}^2" for v*abs(v).
std::string unit_of_factor(const FormulaDimension& of);

/// The unit of that dimension itself: "{position}/s", "1".
std::string unit_of(const FormulaDimension& dimension);

/// Of each parameter that divides something or stands in a sum the dimension that the other side gives it, once a
/// place.
std::multimap<std::string, FormulaDimension> inner_dimensions(const Expression& expression);

}  // namespace lacuna
