#pragma once

#include <lacuna/error.h>
#include <lacuna/parameter.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace lacuna {

/// The value of a parameter that is a count, such as a population. Throws `Error` where it is not a whole number or is
/// negative.
inline std::size_t count_parameter(const ParameterDeclaration& declaration, double value) {
  if (value >= 0.0 && value < 0x1.0p53 && std::floor(value) == value) return static_cast<std::size_t>(value);
  throw Error(declaration.name + " = " + std::to_string(value) + " is a count; give it a whole number, such as " +
              std::to_string(std::llround(declaration.default_value)));
}

}  // namespace lacuna
