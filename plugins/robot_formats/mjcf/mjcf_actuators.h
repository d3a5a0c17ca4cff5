#pragma once

#include "mjcf_file.h"

namespace lacuna::mjcf {

/// Motors of joints, as the program has them. `inertias` are those that the joints feel at position zero, by body and
/// joint, for what says a damping ratio. Tendons, sites and bodies are driven by nothing.
std::vector<ActuatorSpec> read_actuators(const Document& document, const DefaultClasses& classes,
                                         const std::vector<std::vector<double>>& inertias, File& file);

}  // namespace lacuna::mjcf
