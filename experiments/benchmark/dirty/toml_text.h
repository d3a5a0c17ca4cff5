#pragma once

#include "plant/plant_spec.h"

#include <string>

namespace hidden_effects::dirty {

/// A number as TOML takes a float.
std::string toml_number(double value);

/// The vector (x, 0, z).
std::string toml_vector(const InPlane& at);

}  // namespace hidden_effects::dirty
