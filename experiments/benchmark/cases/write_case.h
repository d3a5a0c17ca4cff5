#pragma once

#include "cases/make_case.h"

#include <filesystem>

namespace hidden_effects {

/// What a user would have of a case: `rig.toml`, `robot.toml`, a CSV file for each trial. The truth is not among it.
void write_case(const MadeCase& made, const std::filesystem::path& folder);

/// "N*m": what the case's files have a drive's commands in.
std::string unit_of_command(const PlantSpec& spec, const PlantDrive& drive);

/// The address that the experiment's file has for where a law stands, "joint.hinge"; empty for the world.
std::string where_of(const LawKind& kind, int element, const PlantSpec& spec);

}  // namespace hidden_effects
