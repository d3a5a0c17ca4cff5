#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// The scale on which a search or a fit steps through a parameter's range.
enum class Scale { linear, logarithmic };

/// A numeric parameter of a component, declared as data so that the host can check, document, fit and store it without
/// knowing the component.
struct ParameterDeclaration {
  std::string name;  ///< lower_snake, unique within its component; must not change after a release
  std::string unit;  ///< SI, as in "N*m*s/rad"; "1" for no unit; for an effect it may contain placeholders such as
                     ///< {force}, see physical_effect.h
  double default_value = 0.0;
  double lower = 0.0;  ///< smallest allowed value, inclusive
  double upper = 0.0;  ///< largest allowed value, inclusive
  Scale scale = Scale::linear;
  std::string description;  ///< one sentence
};

using ParameterDeclarations = std::vector<ParameterDeclaration>;

/// One number of a model that may vary, within its search bounds.
struct FreeParameter {
  std::string address;  ///< `body.torso.mass`, `effect.friction.torque`; of a single setup: `body.load.mass@heavy`
  std::string unit;     ///< SI
  double lower = 0.0;
  double upper = 0.0;
  double start = 0.0;  ///< default value
  Scale scale = Scale::linear;
};

}  // namespace lacuna
