#pragma once

#include "config/schema/experiment.h"
#include "foundation/text/problem.h"
#include "loading/plugin_catalog.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// What was done with something in a robot file of others, and where it stands.
struct RobotFileNote {
  SourceLocation location;
  std::string text;
};

/// Has the robot files of an experiment that are not TOML read by the format plugins whose endings they have; from then
/// on they are like declared robots. Then joints that `held` names stand still, in robots of any format. Throws
/// `BadInput` with all that is wrong with them, `Error` where no format has the ending.
std::vector<RobotFileNote> read_robot_files(Experiment& experiment, const PluginCatalog& catalog);

/// The name of the plugin that reads such a file: by its ending, and by its text where several have the ending. Throws
/// `BadInput` where none has it.
std::string robot_format_of(const std::filesystem::path& file, const std::string& text, const PluginCatalog& catalog);

}  // namespace lacuna
