#pragma once

#include "config/locations.h"
#include "config/reading.h"
#include "config/robot_file.h"

namespace lacuna {

/// The body with sizes of its shapes, mass, centre of mass and inertia resolved: as given, else
/// from its shapes. What is missing, given twice or impossible is a problem.
BodySpec resolve_body(const BodyInFile& body, const Locations& locations, Reading& reading);

}  // namespace lacuna
