#pragma once

#include "config/toml/locations.h"
#include "config/toml/reading.h"
#include "config/schema/robot_file.h"

namespace lacuna {

/// The body with sizes of its shapes, mass, centre of mass and inertia resolved: as given, else
/// from its shapes. Missing, repeated or impossible values are problems.
BodySpec resolve_body(const BodyInFile& body, const Locations& locations, Reading& reading);

}  // namespace lacuna
