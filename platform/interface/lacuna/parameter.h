#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// How a search or a fit steps through a parameter's range.
enum class Scale { linear, logarithmic };

/// One number that a component takes, declared as data so that the host can check,
/// document, fit and store it without knowing the component.
struct ParameterDeclaration {
  std::string name;  ///< lower_snake, unique within its component; a promise once released
  std::string unit;  ///< SI, as in "N*m*s/rad"; "1" where it has none; an effect's may hold words such as
                     ///< {force}, see physical_effect.h
  double default_value = 0.0;
  double lower = 0.0;  ///< smallest value that makes sense, inclusive
  double upper = 0.0;  ///< largest value that makes sense, inclusive
  Scale scale = Scale::linear;
  std::string description;  ///< one sentence
};

using ParameterDeclarations = std::vector<ParameterDeclaration>;

}  // namespace lacuna
