#pragma once

#include "config/schema/experiment.h"
#include "foundation/text/problem.h"
#include "loading/plugin_catalog.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// What was done with an element of a foreign robot file, and its place.
struct RobotFileNote {
  SourceLocation location;
  std::string text;
};

/// Reads the robot files of an experiment that are not TOML with the format plugins of their endings; from then on they
/// are like declared robots. Then fixes the joints that `held` names, in robots of any format. Throws `BadInput` with
/// all of their problems, `Error` where no format has the ending.
std::vector<RobotFileNote> read_robot_files(Experiment& experiment, const PluginCatalog& catalog);

/// The name of the plugin that reads such a file: by its ending, and by its text where several have the ending. Throws
/// `BadInput` where there is none.
std::string robot_format_of(const std::filesystem::path& file, const std::string& text, const PluginCatalog& catalog);

}  // namespace lacuna
