#pragma once

#include "app/terminal/options.h"
#include "foundation/files/whole_file.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace lacuna {

/// A robot file to write, and the plugin that writes it.
struct RobotFileToWrite {
  std::string format;  ///< "urdf", "mjcf", "toml"
  std::filesystem::path file;

  /// The file beside it, for what the format has no place for.
  std::filesystem::path model_file() const { return file.string() + ".model.toml"; }
};

/// What `lacuna export` was asked to write of an experiment.
struct RobotExport {
  std::vector<RobotFileToWrite> files;
  std::optional<int> revision = {};  ///< instead of the one that the experiment is at
  Existing existing = Existing::refused;
};

/// Writes the identified robot, fitting the model where it was not fitted yet, and prints what is where. All files are
/// made before the first of them is written. Throws `BadInput` where a file is there, or cannot be written.
void export_robots(const CommonOptions& options, const RobotExport& wanted);

}  // namespace lacuna
