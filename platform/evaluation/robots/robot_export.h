#pragma once

#include "config/schema/experiment.h"
#include "loading/plugin_catalog.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// A robot as a file, and what the format cannot hold.
struct ExportedRobot {
  std::string text;
  std::map<std::string, double> set;  ///< by address: values for `[model] set` beside the file
  std::vector<std::string> left_out;  ///< sentences: content that neither of the two can hold
  bool keeps_original = false;        ///< the file of the model with other numbers
};

/// Writes a robot by the plugin of that name ("urdf"), or as TOML ("toml"). Where the model's file is of that format it
/// is kept, with its comments and meshes, and only numbers are changed. The text is read again, as `file` with the base
/// and the held joints of `model`, and compared with the robot: values that came back with another number are in `set`.
/// Throws `BadInput` where the format cannot write the robot.
ExportedRobot export_robot(const RobotSpec& robot, const std::string& format, const ModelSection& model,
                           const std::string& comment, const std::filesystem::path& file, const PluginCatalog& catalog);

}  // namespace lacuna
