#pragma once

#include "dirty/dirty_case.h"

#include <filesystem>
#include <string>

namespace hidden_effects::dirty {

/// What the owner of a rig would have: `rig.toml`, `robot.toml`, a CSV file or two for each trial. The truth is not
/// among it.
void write_dirty_case(const DirtyCase& made, const std::filesystem::path& folder);

/// The texts of these files, of the recordings with the name of each file's content.
std::string robot_text(const DirtyCase& made);
std::string experiment_text(const DirtyCase& made);

}  // namespace hidden_effects::dirty
