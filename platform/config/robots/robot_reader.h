#pragma once

#include <lacuna/robot_spec.h>

#include "config/toml/locations.h"

#include <filesystem>
#include <string>

namespace lacuna {

/// Reads a robot file (`schema/robot.md`). Throws `BadInput` with every problem found: unknown
/// keys, wrong types and units, joints that name no body, loops, masses that are missing, inertias
/// that no body has. What is not written is derived: mass and inertia from shapes, anchors from
/// where the child is.
RobotSpec read_robot(const std::filesystem::path& file);

/// The same from text; `file` is used in messages. `places`, if given, gets where each key stands: a value's key is its
/// address.
RobotSpec read_robot_text(const std::string& text, const std::filesystem::path& file, Locations* places = nullptr);

}  // namespace lacuna
