#pragma once

#include "config/toml/locations.h"
#include "config/toml/reading.h"
#include "config/schema/robot_file.h"

namespace lacuna {

/// The body with sizes of its shapes, mass, centre of mass and inertia resolved: as given, else
/// from its shapes. What is missing, given twice or impossible is a problem.
BodySpec resolve_body(const BodyInFile& body, const Locations& locations, Reading& reading);

}  // namespace lacuna
