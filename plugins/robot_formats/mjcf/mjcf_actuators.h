#pragma once

#include "mjcf_file.h"

namespace lacuna::mjcf {

/// Motors of joints, as supported by the program. `inertias` are those of the joints at position zero, by body and
/// joint, for damping ratios. Actuators of tendons, sites and bodies are left out.
std::vector<ActuatorSpec> read_actuators(const Document& document, const DefaultClasses& classes,
                                         const std::vector<std::vector<double>>& inertias, File& file);

}  // namespace lacuna::mjcf
